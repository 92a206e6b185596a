//! V0403: a tool is opened or closed where the move before it was to be rounded.

use val3_analysis::body::ExprId;
use val3_lang::motion::MotionRole;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Findings, Phase, Program, Step};
use crate::rule::rule;

rule! {
    /// A tool is opened or closed behind a move whose descriptor asks for a rounded corner.
    ///
    /// ## Why
    /// `open` and `close` wait until the arm has arrived, so the arm stops at the target and the corner is not
    /// rounded (9.5.4, 10.1.2.2). Switch the tool before that move or on the way, and the arm keeps its speed; or pass
    /// a descriptor with `blend=off`, which says what really happens. Where the next move goes back the way the arm
    /// came, as it does from a part that was just picked, the arm stops anyhow, and nothing is reported.
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
    ///   movej(appro(pPick,{0,0,-50,0,0,0}),tGripper,l_mFast)
    ///   open(tGripper)
    ///   movel(pPick,tGripper,l_mFast)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pPick
    /// tool tGripper
    ///
    /// program start()
    ///   mdesc l_mFast
    /// begin
    ///   l_mFast.blend=joint
    ///   open(tGripper)
    ///   movej(appro(pPick,{0,0,-50,0,0,0}),tGripper,l_mFast)
    ///   movel(pPick,tGripper,l_mFast)
    /// end
    /// ```
    V0403 "blend-cancelled" Info, Program: check
}

fn check(program: &Program<'_>, found: &mut Findings) {
    for (at, step) in program.motion_steps().iter().enumerate() {
        let is_tool = |id| program.inference.ty(id).base.builtin() == Some(BaseType::Tool);
        let (MotionRole::Arrive, Phase::Moving, Some(last)) = (step.role, step.arm.phase, step.arm.last) else {
            continue;
        };
        if step.call.args.iter().copied().any(is_tool) && program.is_blended(last) && !turns_back(program, at, last) {
            let descriptor = program.descriptor(last).unwrap_or(last);
            found
                .report(&RULE, program.range(step.call.id), word(step.call.instruction.name))
                .related(program.range(descriptor), "this descriptor asks for a rounded corner");
        }
    }
}

/// Behind the step with the number `at` the arm leaves the target of its last move the way it came: to a point that is
/// computed from it, or to the target before.
fn turns_back(program: &Program<'_>, at: usize, last: ExprId) -> bool {
    let (before, behind) = program.motion_steps().split_at(at);
    let is_move = |step: &&Step<'_>| matches!(step.role, MotionRole::Move(_));
    let target = |step: Option<&Step<'_>>| program.target(step?.call.id);
    let (Some(here), Some(next)) = (program.target(last), target(behind.iter().find(is_move))) else { return false };
    let same = |one, other| program.body.is_same(one, other);
    let previous = target(before.iter().filter(is_move).rev().find(|step| step.call.id != last));
    program.body.within(next).into_iter().any(|part| part != next && same(part, here))
        || previous.is_some_and(|previous| same(previous, next))
}

fn word(instruction: &str) -> Wording {
    Wording::new(
        format!("`{instruction}` waits for the arm, so the corner of the move before is not rounded"),
        "the arm stops here",
        "switch the tool elsewhere, or pass that move a descriptor with `blend` off",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!(
            "point pA\npoint pB\ntool tA\nmdesc mA\nbool bA\n\nprogram start()\n  mdesc l_m\nbegin\n{code}\nend\n\n\
             program other()\nbegin\nend"
        )
    }

    #[test]
    fn a_rounded_corner_at_the_tool() {
        expect![[r#"
            start.pgx:10 `open(tA)` `open` waits for the arm, so the corner of the move before is not rounded
              | the arm stops here
              ? switch the tool elsewhere, or pass that move a descriptor with `blend` off
              > start.pgx:9 `mA` this descriptor asks for a rounded corner
        "#]]
        .assert_eq(&check(&RULE, &program("mA.blend=Cartesian\nmovel(pA,tA,mA)\nopen(tA)")));
        expect![[r#"
            start.pgx:11 `close(tA)` `close` waits for the arm, so the corner of the move before is not rounded
              | the arm stops here
              ? switch the tool elsewhere, or pass that move a descriptor with `blend` off
              > start.pgx:10 `l_m` this descriptor asks for a rounded corner
        "#]]
        .assert_eq(&check(&RULE, &program("l_m=mA\nl_m.blend=joint\nmovel(pA,tA,l_m)\nclose(tA)")));
    }

    #[test]
    fn no_corner_to_round() {
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

    #[test]
    fn a_way_on_and_a_way_back() {
        let blended = |lines: &str| check(&RULE, &program(&format!("mA.blend=joint\n{lines}")));
        let appro = "appro(pA,{0,0,-9,0,0,0})";
        assert!(!blended(&format!("movej({appro},tA,mA)\nopen(tA)\nmovel(pA,tA,mA)")).is_empty());
        assert!(!blended("movej(pB,tA,mA)\nmovel(pA,tA,mA)\nopen(tA)\nmovej(appro(pB,{0,0,0,0,0,0}),tA,mA)").is_empty());
        assert_eq!(blended(&format!("movel(pA,tA,mA)\nopen(tA)\nmovel({appro},tA,mA)")), "");
        assert_eq!(blended("mA.blend=joint\nmovel(pB,tA,mA)\nmovel(pA,tA,mA)\nopen(tA)\nmovel(pB,tA,mA)"), "");
    }
}
