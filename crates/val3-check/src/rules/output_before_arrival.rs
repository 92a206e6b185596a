//! V0406: an output that is set before the arm arrives.

use rustc_hash::FxHashSet;
use val3_analysis::body::ExprId;
use val3_analysis::flow::{FlowNode, FlowNodeId, PointKind};
use val3_lang::instruction::{CallClass, Family};
use val3_lang::instructions::WAIT_END_MOVE;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{ArmActivity, Call, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// An output is set directly after a move, without a `waitEndMove` between them.
    ///
    /// ## Why
    /// A move is only recorded: the program continues immediately, far ahead of the arm (10.2). The output is set when
    /// the arm starts, not when it arrives. Ignore the finding if this is intended.
    ///
    /// ## Bad
    /// ```val3
    /// point pPick
    /// tool tGripper
    /// mdesc mSlow
    /// dio doVacuum
    ///
    /// movel(pPick,tGripper,mSlow)
    /// doVacuum=true
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pPick
    /// tool tGripper
    /// mdesc mSlow
    /// dio doVacuum
    ///
    /// movel(pPick,tGripper,mSlow)
    /// waitEndMove()
    /// doVacuum=true
    /// ```
    V0406 "output-before-arrival" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let Some(motion) = program.motion() else { return };
    let wait = format!("{WAIT_END_MOVE}()");
    let mut told = FxHashSet::default();
    for (id, point) in program.flow().points() {
        let arm = motion.arm(id);
        let Some(last) = arm.last.filter(|_| arm.phase == ArmActivity::Moving) else { continue };
        // The first output after a move is enough.
        if let Some(output) = output(program, id, point).filter(|_| told.insert(last)) {
            let target = program.target(last).unwrap_or(last);
            found
                .report(&RULE, point.range, word(program.text(output), program.text(target)))
                .related(program.range(last), "the arm only starts here")
                .fix("wait for the arm", false, [program.site(point.range).line_before(&wait)]);
        }
    }
}

/// Output that is set at a flow node.
fn output(program: &ProgramView<'_>, id: FlowNodeId, point: &FlowNode) -> Option<ExprId> {
    match point.kind {
        PointKind::Assign { target, .. } => Some(target).filter(|id| is_output(program, *id)),
        _ => program.calls_at(id).iter().filter_map(set_variable).find(|id| is_output(program, *id)),
    }
}

/// First argument of an instruction that sets an input or output.
fn set_variable(call: &Call<'_>) -> Option<ExprId> {
    let form = call.form.filter(|form| form.class == CallClass::Modifier)?;
    let sets_number = form.params.get(1).is_some_and(|param| param.ty == Some(BaseType::Num));
    let is_setter = call.instruction.family == Family::Io && sets_number;
    call.args.first().copied().filter(|_| is_setter)
}

fn is_output(program: &ProgramView<'_>, id: ExprId) -> bool {
    matches!(program.inference.ty(id).base.builtin(), Some(BaseType::Dio | BaseType::Aio))
}

fn word(output: &str, target: &str) -> Wording {
    Wording::new(
        format!("`{output}` is set before the arm has reached `{target}`"),
        "set while the arm is on its way",
        "if the arm must be there first, call `waitEndMove()` before this line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::fix_testing::fixed;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!("point pA\ntool tA\nmdesc mA\nbool bA\nnum nA\ndio dA\naio aA\n\n{code}")
    }

    #[test]
    fn an_output_before_the_arrival_is_reported() {
        expect![[r#"
            start.pgx:8 `dA=true` `dA` is set before the arm has reached `pA`
              | set while the arm is on its way
              ? if the arm must be there first, call `waitEndMove()` before this line
              > start.pgx:6 `movel(pA,tA,mA)` the arm only starts here
              ! wait for the arm (unsafe)
            start.pgx:11 `aioSet(aA,3)` `aA` is set before the arm has reached `pA`
              | set while the arm is on its way
              ? if the arm must be there first, call `waitEndMove()` before this line
              > start.pgx:10 `movej(pA,tA,mA)` the arm only starts here
              ! wait for the arm (unsafe)
            start.pgx:13 `tA.gripper=true` `tA.gripper` is set before the arm has reached `pA`
              | set while the arm is on its way
              ? if the arm must be there first, call `waitEndMove()` before this line
              > start.pgx:12 `movej(pA,tA,mA)` the arm only starts here
              ! wait for the arm (unsafe)
        "#]].assert_eq(&check(
            &RULE,
            &program("movel(pA,tA,mA)\nnA=1\ndA=true\ndA=false\nmovej(pA,tA,mA)\naioSet(aA,3)\nmovej(pA,tA,mA)\ntA.gripper=true"),
        ));
    }

    #[test]
    fn the_fix_waits_for_the_arrival() {
        expect![[r#"
            if bA
              movel(pA,tA,mA)
              waitEndMove()
              dA=true
            endIf
            end"#]]
        .assert_eq(&fixed(&RULE, &program("if bA\n  movel(pA,tA,mA)\n  dA=true\nendIf")));
    }

    #[test]
    fn an_output_after_the_arrival_is_not_reported() {
        let lines =
            ["waitEndMove()", "open(tA)", "wait(getMoveId()>3)", "delay(1)", "wait(isSettled())", "resetMotion()"];
        for line in lines {
            assert_eq!(check(&RULE, &program(&format!("movel(pA,tA,mA)\n{line}\ndA=true"))), "", "{line}");
        }
        assert_eq!(check(&RULE, &program("if bA\nmovel(pA,tA,mA)\nendIf\ndA=true")), "");
        assert_eq!(check(&RULE, &program("movel(pA,tA,mA)\nbA=dA\nnA=aioGet(aA)")), "");
    }
}
