//! V0401: a local point, frame or tool that is used before it has a reference.

use std::rc::Rc;

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::body::ExprId;
use val3_analysis::effects::{AccessKind, RootVariable};
use val3_analysis::flow::{FlowNode, FlowNodeId, PointKind, forward};
use val3_lang::motion::{missing_reference, needs_reference};
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Call, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A local point, frame or tool is used before it has been given a reference.
    ///
    /// ## Why
    /// Local variables, and the fields of local variables of user types, start without a reference frame or tool. An
    /// instruction that computes or moves with them stops the task with run-time error 162, 163 or 164. They get a
    /// reference from an assignment or from `link`; an assignment to `trsf` is not enough.
    ///
    /// ## Bad
    /// ```val3
    /// tool tGripper
    /// mdesc mFast
    ///
    /// program start()
    ///   point l_pAbove
    /// begin
    ///   l_pAbove.trsf.z=200
    ///   movej(l_pAbove,tGripper,mFast)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// tool tGripper
    /// mdesc mFast
    ///
    /// program start()
    ///   point l_pAbove
    /// begin
    ///   link(l_pAbove,world)
    ///   l_pAbove.trsf.z=200
    ///   movej(l_pAbove,tGripper,mFast)
    /// end
    /// ```
    V0401 "no-reference" Error, Program: check
}

/// Variables that may have a father, as spelled in the code: `l_pPick`, `l_tSlot.pPick`. An entry for a structure also
/// covers its fields.
type ReferencedVariables = FxHashSet<SmolStr>;

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let may_lack = |ty: &str| BaseType::from_file_name(ty).is_none_or(|(ty, _)| ty.has_father());
    if !program.header.locals.iter().any(|local| may_lack(&local.type_name)) {
        return;
    }
    let flow = program.flow();
    let step = |id: FlowNodeId, point: &FlowNode, before: &Rc<ReferencedVariables>| after(program, id, point, before);
    let facts = forward(flow, Rc::default(), step, |known, more| {
        let news = !Rc::ptr_eq(known, more) && !more.is_subset(known);
        if news {
            Rc::make_mut(known).extend(more.iter().cloned());
        }
        news
    });
    let mut told = ReferencedVariables::default();
    for (id, _) in flow.points() {
        let Some(linked) = facts.before(id) else { continue };
        for call in program.calls_at(id) {
            let mut has_failed = false;
            for (arg, ty) in needed(call) {
                let Some(name) = local(program, arg).filter(|name| !is_linked(linked, name)) else { continue };
                let wording = word(program.text(arg), ty, call.instruction.name, has_failed);
                has_failed = true;
                if told.insert(name) {
                    found.report(&RULE, program.range(arg), wording);
                }
            }
        }
    }
}

/// Run-time error of a value of this type without a father, in brackets; empty if an earlier argument of the line fails.
pub(super) fn error_of(ty: BaseType, has_failed: bool) -> String {
    let number = missing_reference(ty).filter(|_| !has_failed);
    number.map(|number| format!(" (run-time error {number})")).unwrap_or_default()
}

/// Arguments that need a father.
pub(super) fn needed<'a>(call: &Call<'a>) -> impl Iterator<Item = (ExprId, BaseType)> {
    let (instruction, args) = (call.instruction, call.args);
    let params = call.form.into_iter().flat_map(|form| form.params);
    let needed = params.zip(args).filter(|(param, _)| needs_reference(instruction, param));
    needed.filter_map(|(param, arg)| Some((*arg, param.ty?)))
}

fn after(
    program: &ProgramView<'_>,
    id: FlowNodeId,
    point: &FlowNode,
    before: &Rc<ReferencedVariables>,
) -> Rc<ReferencedVariables> {
    let writes = program.effects.at(id).iter().filter(|access| access.kind != AccessKind::Read);
    let linked: Vec<SmolStr> = writes
        .filter(|_| !copies_nothing(program, point, before))
        .filter_map(|access| local(program, access.id))
        .filter(|name| !before.contains(name))
        .collect();
    if linked.is_empty() {
        return before.clone();
    }
    let mut after = ReferencedVariables::clone(before);
    after.extend(linked);
    Rc::new(after)
}

/// Whether it is an assignment `l_pA=l_pB` in which `l_pB` has no father either.
fn copies_nothing(program: &ProgramView<'_>, point: &FlowNode, linked: &ReferencedVariables) -> bool {
    let PointKind::Assign { value, .. } = point.kind else { return false };
    let has_father = program.inference.ty(value).base.builtin().is_some_and(BaseType::has_father);
    has_father && local(program, value).is_some_and(|name| !is_linked(linked, &name))
}

fn is_linked(linked: &ReferencedVariables, name: &str) -> bool {
    let ends = name.match_indices('.').map(|(at, _)| at).chain([name.len()]);
    ends.into_iter().any(|end| name.get(..end).is_some_and(|whole| linked.contains(whole)))
}

/// Local variable or a field of it, without indexes: array elements are not distinguished.
fn local(program: &ProgramView<'_>, id: ExprId) -> Option<SmolStr> {
    matches!(program.effects.root(id)?, RootVariable::Local(_)).then(|| program.path_without_indexes(id))
}

/// Returns the wording of the finding. If the line fails at an earlier argument, its run-time error has another number.
fn word(name: &str, ty: BaseType, instruction: &str, has_failed: bool) -> Wording {
    let (what, from) = match ty {
        BaseType::Tool => ("tool", "flange"),
        _ => ("frame", "world"),
    };
    let error = error_of(ty, has_failed);
    Wording::new(
        format!("the {} `{name}` has no reference {what} when `{instruction}` uses it{error}", ty.name()),
        "no reference yet",
        format!("assign a {} that has one before, or `link({name},{from})`", ty.name()),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!(
            "point pA\nframe fA\ntool tA\nmdesc mA\nbool bA\njoint jA\n\nprogram start()\n  point l_p\n  point l_q[3]\n  \
             frame l_f\n  tool l_t\nbegin\n{code}\nend\n\nprogram change(point& x_p)\nbegin\n  x_p=pA\nend"
        )
    }

    #[test]
    fn a_point_used_before_it_has_a_reference_is_reported() {
        expect![[r#"
            start.pgx:11 `l_p` the point `l_p` has no reference frame when `movel` uses it (run-time error 162)
              | no reference yet
              ? assign a point that has one before, or `link(l_p,world)`
            start.pgx:12 `l_t` the tool `l_t` has no reference tool when `movel` uses it (run-time error 164)
              | no reference yet
              ? assign a tool that has one before, or `link(l_t,flange)`
            start.pgx:13 `l_q[1]` the point `l_q[1]` has no reference frame when `appro` uses it (run-time error 162)
              | no reference yet
              ? assign a point that has one before, or `link(l_q[1],world)`
            start.pgx:14 `l_f` the frame `l_f` has no reference frame when `here` uses it (run-time error 163)
              | no reference yet
              ? assign a frame that has one before, or `link(l_f,world)`
        "#]]
        .assert_eq(&check(
            &RULE,
            &program("movel(l_p,tA,mA)\nmovel(pA,l_t,mA)\nl_q[0]=appro(l_q[1],{0,0,1,0,0,0})\nl_p=here(tA,l_f)"),
        ));
    }

    /// An instruction reads its arguments from left to right, and fails at the first one without a reference.
    #[test]
    fn only_the_first_argument_that_fails_names_the_error() {
        let report = check(&RULE, &program("?position(l_p,l_f)\n?here(l_t,l_f)"));
        assert!(report.contains("the point `l_p` has no reference frame when `position` uses it (run-time error 162)"));
        assert!(report.contains("the frame `l_f` has no reference frame when `position` uses it\n"), "{report}");
        assert!(report.contains("the tool `l_t` has no reference tool when `here` uses it (run-time error 164)"));
    }

    #[test]
    fn setting_a_position_gives_no_reference() {
        for line in ["l_p.trsf.x=1", "l_p.trsf={0,0,0,0,0,0}", "l_q[1]=l_p", "l_p=l_q[0]"] {
            assert_ne!(check(&RULE, &program(&format!("{line}\nmovej(l_p,tA,mA)"))), "", "{line}");
        }
    }

    #[test]
    fn points_with_a_reference_are_not_reported() {
        let lines = ["link(l_p,fA)", "l_p=pA", "l_p=here(tA,fA)", "call change(l_p)", "l_p=jointToPoint(tA,fA,jA)"];
        for line in lines.into_iter().chain(["if bA\nl_p=pA\nendIf", "l_q[1]=pA\nl_p=l_q[2]"]) {
            assert_eq!(check(&RULE, &program(&format!("{line}\nmovej(l_p,tA,mA)"))), "", "{line}");
        }
    }

    #[test]
    fn a_reference_given_after_the_use_is_reported() {
        expect![[r#"
            start.pgx:11 `l_p` the point `l_p` has no reference frame when `movej` uses it (run-time error 162)
              | no reference yet
              ? assign a point that has one before, or `link(l_p,world)`
        "#]]
        .assert_eq(&check(&RULE, &program("movej(l_p,tA,mA)\nl_p=pA\nmovej(l_p,tA,mA)")));
        assert_eq!(check(&RULE, &program("while bA\nif bA\nmovej(l_p,tA,mA)\nendIf\nl_p=pA\nendWhile")), "");
    }

    #[test]
    fn set_frame_gives_a_reference() {
        assert_eq!(check(&RULE, &program("if setFrame(pA,pA,pA,l_f)==0\nl_p=here(tA,l_f)\nendIf")), "");
    }

    fn with_user_type(code: &str) -> String {
        format!(
            "type Slot \"Disk://Slot/Slot.pjx\"\ntool tA\nmdesc mA\npoint pA\n\nprogram start()\n  Slot l_s\nbegin\n\
             {code}\nend\n\n--- Slot\npublic point pIn\n"
        )
    }

    #[test]
    fn fields_of_user_types_are_checked() {
        expect![[r#"
            start.pgx:8 `l_s.pIn` the point `l_s.pIn` has no reference frame when `movej` uses it (run-time error 162)
              | no reference yet
              ? assign a point that has one before, or `link(l_s.pIn,world)`
        "#]]
        .assert_eq(&check(&RULE, &with_user_type("movej(l_s.pIn,tA,mA)")));
        assert_eq!(check(&RULE, &with_user_type("l_s.pIn=pA\nmovej(l_s.pIn,tA,mA)")), "");
    }
}
