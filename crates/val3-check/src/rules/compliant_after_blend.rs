//! V0404: a compliant move after a move with a rounded corner.

use val3_lang::motion::{MotionRole, RequestedPath};

use crate::diagnostic::Wording;
use crate::lint::{ArmActivity, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A compliant move follows a move whose descriptor requests a blend.
    ///
    /// ## Why
    /// The arm stops at both ends of a compliant move (11.1.4), so the corner is not rounded. Give the previous move a
    /// descriptor with `blend=off`.
    ///
    /// ## Bad
    /// ```val3
    /// point pAbove
    /// point pInside
    /// tool tGripper
    ///
    /// program start()
    ///   mdesc l_mSlow
    /// begin
    ///   l_mSlow.blend=Cartesian
    ///   movel(pAbove,tGripper,l_mSlow)
    ///   movelf(pInside,tGripper,l_mSlow,20)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pAbove
    /// point pInside
    /// tool tGripper
    ///
    /// program start()
    ///   mdesc l_mSlow
    /// begin
    ///   l_mSlow.blend=off
    ///   movel(pAbove,tGripper,l_mSlow)
    ///   movelf(pInside,tGripper,l_mSlow,20)
    /// end
    /// ```
    V0404 "compliant-after-blend" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let role_of = |call| program.call_of(call).and_then(|call| call.role);
    for step in program.arm_calls() {
        let compliant = MotionRole::Move(RequestedPath::Compliant);
        let is_compliant = step.role == compliant && step.arm.phase == ArmActivity::Moving;
        let Some(last) =
            step.arm.last.filter(|last| is_compliant && role_of(*last) != Some(compliant) && program.is_blended(*last))
        else {
            continue;
        };
        let descriptor = program.descriptor(last).unwrap_or(last);
        found
            .report(&RULE, program.range(step.call.callee), word(step.call.instruction.name))
            .related(program.range(descriptor), "this descriptor requests a blend");
    }
}

fn word(instruction: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` starts from a standstill, so the corner of the move before is not rounded"),
        "the arm stops before this move",
        "pass the move before a descriptor with `blend` off",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!("point pA\njoint jA\ntool tA\nmdesc mA\n\n{code}")
    }

    #[test]
    fn a_compliant_move_after_a_rounded_corner_is_reported() {
        expect![[r#"
            start.pgx:8 `movejf` `movejf` starts from a standstill, so the corner of the move before is not rounded
              | the arm stops before this move
              ? pass the move before a descriptor with `blend` off
              > start.pgx:7 `mA` this descriptor requests a blend
        "#]]
        .assert_eq(&check(&RULE, &program("mA.blend=joint\nmovej(pA,tA,mA)\nmovejf(jA,tA,mA,0)\nmovelf(pA,tA,mA,0)")));
    }

    #[test]
    fn a_compliant_move_after_a_stop_is_not_reported() {
        for between in
            ["mA.blend=off\nmovej(pA,tA,mA)", "movej(pA,tA,mA)", "mA.blend=joint\nmovej(pA,tA,mA)\nwaitEndMove()"]
        {
            assert_eq!(check(&RULE, &program(&format!("{between}\nmovelf(pA,tA,mA,0)"))), "", "{between}");
        }
    }
}
