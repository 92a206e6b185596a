//! V0403: a tool is opened or closed after a move with a rounded corner.

use val3_lang::motion::MotionRole;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{ArmActivity, Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// `open` or `close` follows a move whose descriptor requests a blend.
    ///
    /// ## Why
    /// `open` and `close` wait until the arm has arrived, so the arm stops at the target and the corner is not rounded
    /// (9.5.4, 10.1.2.2). A descriptor with `blend=off` describes the real movement and preserves it if the instruction
    /// is moved later. The default, `joint` with the default distances, is not reported.
    ///
    /// ## Bad
    /// ```val3
    /// point pPick
    /// tool tGripper
    ///
    /// program start()
    ///   mdesc l_mFast
    /// begin
    ///   l_mFast.blend=joint
    ///   movel(pPick,tGripper,l_mFast)
    ///   close(tGripper)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pPick
    /// tool tGripper
    ///
    /// program start()
    ///   mdesc l_mSlow
    /// begin
    ///   l_mSlow.blend=off
    ///   movel(pPick,tGripper,l_mSlow)
    ///   close(tGripper)
    /// end
    /// ```
    V0403 "blend-cancelled" Info, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for step in program.arm_calls() {
        let (MotionRole::Arrive, ArmActivity::Moving, Some(last)) = (step.role, step.arm.phase, step.arm.last) else {
            continue;
        };
        let mut types = step.call.args.iter().map(|id| program.inference.ty(*id).base.builtin());
        if types.any(|ty| ty == Some(BaseType::Tool)) && program.is_blended(last) {
            let descriptor = program.descriptor(last).unwrap_or(last);
            found
                .report(&RULE, program.range(step.call.id), word(step.call.instruction.name))
                .related(program.range(descriptor), "this descriptor requests a blend");
        }
    }
}

fn word(instruction: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` waits for the arm, so the corner of the move before is not rounded"),
        "the arm stops here",
        "pass that move a descriptor with `blend` off",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!(
            "point pA\ntool tA\nmdesc mA\nbool bA\n\nprogram start()\n  mdesc l_m\nbegin\n{code}\nend\n\n\
             program other()\nbegin\nend"
        )
    }

    #[test]
    fn a_rounded_corner_before_an_instruction_that_waits_for_the_arm_is_reported() {
        expect![[r#"
            start.pgx:10 `open(tA)` `open` waits for the arm, so the corner of the move before is not rounded
              | the arm stops here
              ? pass that move a descriptor with `blend` off
              > start.pgx:9 `mA` this descriptor requests a blend
        "#]]
        .assert_eq(&check(&RULE, &program("mA.blend=Cartesian\nmovel(pA,tA,mA)\nopen(tA)")));
        expect![[r#"
            start.pgx:11 `close(tA)` `close` waits for the arm, so the corner of the move before is not rounded
              | the arm stops here
              ? pass that move a descriptor with `blend` off
              > start.pgx:10 `l_m` this descriptor requests a blend
        "#]]
        .assert_eq(&check(&RULE, &program("l_m=mA\nl_m.blend=joint\nmovel(pA,tA,l_m)\nclose(tA)")));
    }

    fn with_descriptor(attributes: &str) -> String {
        format!(
            "movel(pA,flange,mX)\nopen(tA)\n\n=== main/main.dtx\n<?xml version=\"1.0\" \
             encoding=\"utf-8\"?>\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
             xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n    \
             <Data name=\"mX\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\">\n      \
             <Value key=\"0\" {attributes} />\n    </Data>\n    \
             <Data name=\"pA\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"1\" />\n    \
             <Data name=\"tA\" access=\"private\" xsi:type=\"array\" type=\"tool\" size=\"1\" />\n  \
             </Datas>\n</Database>\n"
        )
    }

    #[test]
    fn the_default_blend_is_not_reported() {
        for chosen in ["leave=\"120\"", "blend=\"cartesian\"", "reach=\"5\""] {
            assert_ne!(check(&RULE, &with_descriptor(chosen)), "", "{chosen}");
        }
        for default in ["vel=\"50\"", "blend=\"joint\" leave=\"50\" reach=\"50\"", "blend=\"off\" leave=\"9\""] {
            assert_eq!(check(&RULE, &with_descriptor(default)), "", "{default}");
        }
        assert_eq!(check(&RULE, &program("l_m=mA\nl_m.vel=50\nmovel(pA,tA,l_m)\nclose(tA)")), "");
        assert_eq!(check(&RULE, &program("movel(pA,tA,l_m)\nclose(tA)")), "");
    }

    #[test]
    fn moves_without_a_corner_are_not_reported() {
        let lines = [
            "mA.blend=off\nmovel(pA,tA,mA)\nopen(tA)",
            "mA.blend=joint\nmovel(pA,tA,mA)\nwaitEndMove()",
            "mA.blend=joint\nmovel(pA,tA,mA)\nwaitEndMove()\nopen(tA)",
            "mA.blend=joint\ncall other()\nmovel(pA,tA,mA)\nopen(tA)",
            "mA.blend=joint\nif bA\nmA.blend=off\nendIf\nmovel(pA,tA,mA)\nopen(tA)",
            "mA.blend=joint\nmovel(pA,tA,mA)\ncall other()\nopen(tA)",
        ];
        for line in lines {
            assert_eq!(check(&RULE, &program(line)), "", "{line}");
        }
    }
}
