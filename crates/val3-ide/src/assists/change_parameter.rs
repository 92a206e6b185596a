//! Moves or removes the parameter at the cursor, or changes its passing, in the program's code or in the declaration.
//! All callers are adapted.

mod passing;

use val3_analysis::items::declarations::all_params;
use val3_analysis::occurrences::Symbol;

use super::context::Context;
use super::{AssistKind, Assists};
use crate::FilePosition;
use crate::change_signature::{NewParameter, NewVariables, change_signature, in_code};
use crate::navigate::name_at;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let index = parameter_at(context)?;
    let header = context.header();
    let param = header.params.get(index)?;
    let name = &param.name;
    let mut offers = ChangeOffers { context, assists };
    if let Some(before) = index.checked_sub(1) {
        let title = format!("Move parameter `{name}` left");
        offers.add("move-parameter-left", title, |new| new.swap(before, index));
    }
    if index + 1 < header.params.len() {
        let title = format!("Move parameter `{name}` right");
        offers.add("move-parameter-right", title, |new| new.swap(index, index + 1));
    }
    if in_code(context.db, &Symbol::Param(context.file, name.clone())).is_empty() {
        let title = format!("Remove unused parameter `{name}`");
        offers.add("remove-parameter", title, |new| drop(new.remove(index)));
    }
    if passing::can_change(context, index, param) {
        let (id, way) = match param.by_reference {
            true => ("pass-by-value", "value"),
            false => ("pass-by-reference", "reference"),
        };
        offers.add(id, format!("Pass parameter `{name}` by {way}"), |new| {
            new.iter_mut().skip(index).take(1).for_each(|new| new.by_reference = !new.by_reference);
        });
    }
    Some(())
}

/// Adds changes of the parameters to the assists.
struct ChangeOffers<'a, 'c, 'o> {
    context: &'a Context<'c>,
    assists: &'a mut Assists<'o>,
}

impl ChangeOffers<'_, '_, '_> {
    /// Offers the change made by `edit`, disabled with the reason if it is impossible.
    fn add(&mut self, id: &'static str, title: String, edit: impl FnOnce(&mut Vec<NewParameter>)) {
        let mut wanted = NewVariables::of(self.context.header());
        edit(&mut wanted.parameters);
        match change_signature(self.context.db, self.context.file, &wanted) {
            Ok(change) => self.assists.add(id, AssistKind::Rewrite, title, || Some(change)),
            Err(error) => self.assists.refuse(None, id, AssistKind::Rewrite, title, error),
        }
    }
}

/// Index of the parameter whose name or declaration is at the cursor.
fn parameter_at(context: &Context<'_>) -> Option<usize> {
    let offset = context.range.start();
    let declared = all_params(context.db, context.file);
    if let Some(index) = declared.iter().position(|param| param.element.contains_range(context.range)) {
        return Some(index);
    }
    let (_, found) = name_at(context.db, FilePosition { file: context.file, offset })?;
    let Symbol::Param(_, name) = &found.symbol else { return None };
    context.header().params.iter().position(|param| param.name == *name)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, offered, refused};

    const PICK: &str =
        "num nA\ncall pick(1,nA,true)\nprogram pick(num x_nA,num x_nB,bool x_bC)\nbegin\n  put(x_n$0B)\nend";

    #[test]
    fn a_parameter_moves_with_its_arguments() {
        check(
            "move-parameter-left",
            PICK,
            expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nA" type="num" xsi:type="element" />
            -      <Parameter name="x_nB" type="num" xsi:type="element" />
            +      <Parameter name="x_nB" type="num" xsi:type="element" />
            +      <Parameter name="x_nA" type="num" xsi:type="element" />
            usrapp/main/start.pgx
            -call pick(1,nA,true)
            +call pick(nA,1,true)
        "#]],
        );
        let right = done(PICK, "move-parameter-right");
        assert!(right.contains("+call pick(1,true,nA)"), "{right}");
        assert_eq!(offered(PICK, "move-parameter-left").as_deref(), Some("Move parameter `x_nB` left"));
    }

    #[test]
    fn the_first_and_the_last_move_in_one_direction() {
        let first = PICK.replace("put(x_n$0B)", "put(x_n$0A)");
        assert_eq!(offered(&first, "move-parameter-left"), None);
        assert!(offered(&first, "move-parameter-right").is_some());
        let last = PICK.replace("put(x_n$0B)", "x_b$0C=false");
        assert_eq!(offered(&last, "move-parameter-right"), None);
    }

    #[test]
    fn an_unused_parameter_is_removed_at_its_declaration() {
        let listing = "num nZ\n=== main/start.pgx\n<Programs><Program name=\"start\"><Code><![CDATA[begin\n  call other(1,2)\nend]]></Code></Program></Programs>\n\
            === main/other.pgx\n<Programs><Program name=\"other\"><Parameters><Parameter name=\"x_nA\" ty$0pe=\"num\" xsi:type=\"element\"/><Parameter name=\"x_nB\" type=\"num\" xsi:type=\"element\"/></Parameters><Code><![CDATA[begin\n  put(x_nB)\nend]]></Code></Program></Programs>\n";
        check(
            "remove-parameter",
            listing,
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other"><Parameters><Parameter name="x_nA" type="num" xsi:type="element"/><Parameter name="x_nB" type="num" xsi:type="element"/></Parameters><Code><![CDATA[begin
            +<Programs><Program name="other"><Parameters><Parameter name="x_nB" type="num" xsi:type="element"/></Parameters><Code><![CDATA[begin
            usrapp/main/start.pgx
            -  call other(1,2)
            +  call other(2)
        "#]],
        );
        assert_eq!(offered(PICK, "remove-parameter"), None);
    }

    #[test]
    fn arguments_with_an_effect_stay() {
        let listing = PICK.replace("1,nA", "get(),nA");
        assert_eq!(
            refused(&listing, "move-parameter-left").as_deref(),
            Some("the argument `get()` of a call in `start` has an effect, so the order of its arguments matters")
        );
    }

    #[test]
    fn passing_changes_where_nobody_notices() {
        check(
            "pass-by-reference",
            PICK,
            expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nB" type="num" xsi:type="element" />
            +      <Parameter name="x_nB" type="num" xsi:type="element" use="reference" />
        "#]],
        );
        check(
            "pass-by-value",
            &PICK.replace("num x_nB", "num& x_nB"),
            expect![[r#"
            usrapp/main/pick.pgx
            -      <Parameter name="x_nB" type="num" xsi:type="element" use="reference" />
            +      <Parameter name="x_nB" type="num" xsi:type="element" />
        "#]],
        );
        let by_reference = PICK.replace("num x_nB", "num& x_nB");
        for body in ["x_n$0B=1", "nA=x_n$0B", "delay(x_n$0B)", "call pick(x_n$0B,x_nB,true)"] {
            assert_eq!(offered(&by_reference.replace("put(x_n$0B)", body), "pass-by-value"), None, "{body}");
        }
        for call in ["call pick(1,2,true)", "call pick(1,nA+1,true)", "taskCreate \"a\",10,pick(1,nA,true)"] {
            assert_eq!(offered(&PICK.replace("call pick(1,nA,true)", call), "pass-by-reference"), None, "{call}");
        }
        let task = by_reference.replace("call pick(1,nA,true)", "taskCreate \"a\",10,pick(1,nA,true)");
        assert_eq!(offered(&task, "pass-by-value"), None);
        assert_eq!(offered(&PICK.replace("num x_nB", "num& x_nB[]"), "pass-by-value"), None);
    }
}
