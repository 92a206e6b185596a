//! V0311: a local variable that is used before it is set.

use val3_analysis::effects::{AccessKind, RootVariable};
use val3_analysis::items::declarations;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A local position, transformation or motion descriptor is used before the program has set it.
    ///
    /// ## Why
    /// A local joint starts with every axis at 0, a position that few cells can reach without a collision. A local
    /// transformation changes nothing. A local motion descriptor requests full speed and rounded corners (10.5.1).
    /// Numbers, strings and truth values start with 0, "" and false, on which many programs rely: they are not
    /// reported. The rule also ignores a local that no line sets and whose name states that it stays empty, such as
    /// `l_trEmpty` or `l_jZero`, and a local that receives the result of the same line.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mFast
    ///
    /// program home()
    ///   joint l_jHome
    /// begin
    ///   movej(l_jHome,flange,mFast)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// joint jHome
    /// mdesc mFast
    ///
    /// program home()
    ///   joint l_jHome
    /// begin
    ///   l_jHome=jHome
    ///   l_jHome.j1=0
    ///   movej(l_jHome,flange,mFast)
    /// end
    /// ```
    V0311 "unset-local" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    if !program.header.locals.iter().any(|local| followed(&local.type_name).is_some()) {
        return;
    }
    let (local_use, variable_use) = (program.local_use(), program.variable_use());
    let facts = local_use.written(program.flow());
    let mut told = 0;
    for (id, _) in program.flow().points() {
        let Some(mut written) = facts.before(id).copied() else { continue };
        // The line also writes its result to the variable: `pointToJoint(tA,l_j,pA,l_j)` accepts any start position.
        let references = local_use.at(id).iter().filter(|(_, access)| access.kind == AccessKind::Reference);
        let returned = references.fold(0, |all, (bit, _)| all | bit);
        for (bit, access) in local_use.at(id) {
            let is_unset = access.kind == AccessKind::Read && (written | told | returned) & bit == 0;
            let RootVariable::Local(name) = &access.root else { continue };
            let local = program.header.locals.iter().find(|local| is_unset && local.name == *name);
            let is_ever_set = variable_use.locals.get(name).is_some_and(|uses| uses.may_write());
            let local = local.filter(|_| is_ever_set || !is_meant_to_be_empty(name));
            if let Some(ty) = local.and_then(|local| followed(&local.type_name)) {
                told |= bit;
                let reported = found.report(&RULE, program.range(access.id), word(name, ty));
                if let Some(place) = declarations::local(program.db, program.file, name.clone()) {
                    reported.related_in(place, "declared here");
                }
            }
            written |= if access.kind == AccessKind::Read { 0 } else { *bit };
        }
    }
}

/// The type, if its initial value is almost never intended.
fn followed(type_name: &str) -> Option<BaseType> {
    let (ty, _) = BaseType::from_file_name(type_name)?;
    matches!(ty, BaseType::Joint | BaseType::Trsf | BaseType::Config | BaseType::Mdesc).then_some(ty)
}

/// Whether the name indicates that the variable keeps its initial value on purpose.
fn is_meant_to_be_empty(name: &str) -> bool {
    const WORDS: [&str; 7] = ["empty", "zero", "null", "none", "neutral", "identity", "default"];
    let name = name.to_ascii_lowercase();
    WORDS.iter().any(|word| name.contains(word))
}

fn word(name: &str, ty: BaseType) -> Wording {
    let value = match ty {
        BaseType::Joint => "every axis at 0",
        BaseType::Mdesc => "full speed, rounded corners",
        BaseType::Config => "the configuration is kept",
        _ => "no shift and no turn",
    };
    Wording::new(
        format!("the {} `{name}` is used before the program sets it", ty.name()),
        value,
        format!("assign `{name}` before it is used"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!(
            "point pA\nmdesc mA\nbool bA\njoint jA\ntrsf trA\n\nprogram start()\n  joint l_j\n  trsf l_tr\n  mdesc l_m\n  \
             num l_n\n  trsf l_trAll[3]\nbegin\n{code}\nend\n\nprogram set(trsf& x_tr)\nbegin\n  x_tr=trA\nend"
        )
    }

    #[test]
    fn a_local_used_before_it_is_set_is_reported() {
        expect![[r#"
            start.pgx:12 `l_j` the joint `l_j` is used before the program sets it
              | every axis at 0
              ? assign `l_j` before it is used
              > start.pgx:5 `l_j` declared here
            start.pgx:12 `l_m` the mdesc `l_m` is used before the program sets it
              | full speed, rounded corners
              ? assign `l_m` before it is used
              > start.pgx:7 `l_m` declared here
            start.pgx:13 `l_tr` the trsf `l_tr` is used before the program sets it
              | no shift and no turn
              ? assign `l_tr` before it is used
              > start.pgx:6 `l_tr` declared here
            start.pgx:16 `l_trAll[1]` the trsf `l_trAll` is used before the program sets it
              | no shift and no turn
              ? assign `l_trAll` before it is used
              > start.pgx:9 `l_trAll` declared here
        "#]]
        .assert_eq(&check(
            &RULE,
            &program("movej(l_j,flange,l_m)\ntrA=l_tr*l_tr\nl_j=jA\nl_m.vel=3\nl_trAll[0]=l_trAll[1]"),
        ));
    }

    #[test]
    fn a_local_set_first_is_not_reported() {
        let lines = ["l_tr=trA", "l_tr.x=1", "call set(l_tr)", "if bA\nl_tr=trA\nendIf"];
        for line in lines {
            assert_eq!(check(&RULE, &program(&format!("{line}\ntrA=l_tr"))), "", "{line}");
        }
        assert_eq!(check(&RULE, &program("while bA\nif bA\ntrA=l_tr\nendIf\nl_tr=trA\nendWhile")), "");
    }

    #[test]
    fn a_local_set_on_the_line_that_uses_it_counts_as_set() {
        assert_eq!(check(&RULE, &program("if pointToJoint(flange,l_j,pA,l_j)\nmovej(l_j,flange,mA)\nendIf")), "");
        assert_ne!(check(&RULE, &program("if pointToJoint(flange,l_j,pA,jA)\nmovej(jA,flange,mA)\nendIf")), "");
        assert_ne!(check(&RULE, &program("l_tr=l_tr*trA")), "");
    }

    fn with_empty_locals(code: &str) -> String {
        format!(
            "joint jA\ntrsf trA\n\nprogram start()\n  trsf l_trEmpty\n  joint l_jZERO\n  trsf l_trShift\nbegin\n{code}\nend"
        )
    }

    #[test]
    fn locals_that_stay_empty_are_not_reported() {
        assert_eq!(check(&RULE, &with_empty_locals("trA=trA*l_trEmpty\nif jA==l_jZERO\ncls()\nendIf")), "");
        // An unset variable without such a name is reported, and so is a variable that is set after its use.
        assert_ne!(check(&RULE, &with_empty_locals("trA=trA*l_trShift")), "");
        assert_ne!(check(&RULE, &with_empty_locals("trA=trA*l_trEmpty\nl_trEmpty.x=1")), "");
    }

    #[test]
    fn intended_defaults_are_not_reported() {
        assert_eq!(check(&RULE, &program("l_n=l_n+1\nput(size(l_trAll))")), "");
    }
}
