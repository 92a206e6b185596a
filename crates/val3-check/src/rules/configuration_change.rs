//! V0405: a straight move that would have to change the configuration of the arm.

use val3_analysis::body::ExprId;
use val3_lang::enumerations::Enumerator;
use val3_lang::motion::{MotionRole, RequestedPath, is_definite};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// The target of a line or circle requires another configuration than the point before.
    ///
    /// ## Why
    /// Between two configurations the arm passes through positions that lie on no line or circle of the tool, so the
    /// move is impossible (10.1.4.2). The task stops with a run-time error at this move or a later one. Only a joint
    /// move changes the configuration.
    ///
    /// ## Bad
    /// ```val3
    /// point pLeft
    /// point pRight
    /// tool tGripper
    /// mdesc mFast
    ///
    /// pLeft.config.shoulder=lefty
    /// pRight.config.shoulder=righty
    /// movej(pLeft,tGripper,mFast)
    /// movel(pRight,tGripper,mFast)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pLeft
    /// point pRight
    /// tool tGripper
    /// mdesc mFast
    ///
    /// pLeft.config.shoulder=lefty
    /// pRight.config.shoulder=righty
    /// movej(pLeft,tGripper,mFast)
    /// movej(pRight,tGripper,mFast)
    /// ```
    V0405 "configuration-change" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for step in program.arm_calls() {
        if step.role != MotionRole::Move(RequestedPath::Cartesian) {
            continue;
        }
        let (Some(last), Some(target)) = (step.arm.last, program.target(step.call.id)) else { continue };
        let wanted = definite(program, step.call.id);
        let change = definite(program, last).into_iter().find_map(|from| Some((from, other(&wanted, from)?)));
        if let Some((from, to)) = change {
            let before = program.target(last).unwrap_or(last);
            found
                .report(&RULE, program.range(target), word(step.call.instruction.name, from, to))
                .related(program.range(before), format!("the arm starts here with `{}`", from.name));
        }
    }
}

/// Parts of the configuration that the target of a move certainly requires.
fn definite(program: &ProgramView<'_>, call: ExprId) -> Vec<&'static Enumerator> {
    let target = program.target(call);
    let choices = target.map(|target| program.choices_of(call, target)).unwrap_or_default();
    choices.into_iter().map(|choice| choice.value).filter(|value| is_definite(value)).collect()
}

fn other(wanted: &[&'static Enumerator], from: &Enumerator) -> Option<&'static Enumerator> {
    wanted.iter().copied().find(|to| to.ty == from.ty && *to != from)
}

fn word(instruction: &str, from: &Enumerator, to: &Enumerator) -> Wording {
    Wording::new(
        format!("`{instruction}` cannot change the configuration from `{}` to `{}`", from.name, to.name),
        format!("requires `{}`", to.name),
        "reach the point with a joint move, or teach both points in one configuration",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        format!("point pA\npoint pB\ntool tA\nmdesc mA\nbool bA\n\n{code}")
    }

    const SET: &str = "pA.config.elbow=epositive\npB.config.elbow=enegative\n";

    #[test]
    fn a_configuration_set_by_the_program_is_reported() {
        expect![[r#"
            start.pgx:10 `pB` `movec` cannot change the configuration from `epositive` to `enegative`
              | requires `enegative`
              ? reach the point with a joint move, or teach both points in one configuration
              > start.pgx:8 `pA` the arm starts here with `epositive`
        "#]]
        .assert_eq(&check(&RULE, &program(&format!("{SET}movel(pA,tA,mA)\nwaitEndMove()\nmovec(pA,pB,tA,mA)"))));
    }

    #[test]
    fn a_computed_point_has_the_configuration_of_its_point() {
        expect![[r#"
            start.pgx:9 `pB` `movel` cannot change the configuration from `epositive` to `enegative`
              | requires `enegative`
              ? reach the point with a joint move, or teach both points in one configuration
              > start.pgx:8 `appro(pA,{0,0,1,0,0,0})` the arm starts here with `epositive`
        "#]]
        .assert_eq(&check(&RULE, &program(&format!("{SET}movej(appro(pA,{{0,0,1,0,0,0}}),tA,mA)\nmovel(pB,tA,mA)"))));
    }

    fn data_with_elbow(elbow: &str) -> String {
        format!(
            "=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database \
             xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
             xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n    \
             <Data name=\"pX\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"2\">\n      \
             <Value key=\"0\" elbow=\"epositive\" wrist=\"wpositive\" fatherId=\"world[0]\" />\n      \
             <Value key=\"1\" elbow=\"{elbow}\" wrist=\"wpositive\" fatherId=\"world[0]\" />\n    </Data>\n    \
             <Data name=\"tX\" access=\"private\" xsi:type=\"array\" type=\"tool\" size=\"1\" />\n    \
             <Data name=\"mX\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\" />\n  \
             </Datas>\n</Database>\n"
        )
    }

    #[test]
    fn a_configuration_set_in_the_data_is_reported() {
        let code = "movej(pX[0],tX,mX)\nmovel(pX[1],tX,mX)\n";
        expect![[r#"
            start.pgx:6 `pX[1]` `movel` cannot change the configuration from `epositive` to `enegative`
              | requires `enegative`
              ? reach the point with a joint move, or teach both points in one configuration
              > start.pgx:5 `pX[0]` the arm starts here with `epositive`
        "#]]
        .assert_eq(&check(&RULE, &format!("{code}\n{}", data_with_elbow("enegative"))));
        assert_eq!(check(&RULE, &format!("{code}\n{}", data_with_elbow("epositive"))), "");
        assert_eq!(check(&RULE, &format!("pX[1]=pX[0]\n{code}\n{}", data_with_elbow("enegative"))), "");
    }

    #[test]
    fn a_free_or_equal_configuration_is_not_reported() {
        let lines = [
            "pA.config.elbow=epositive\nmovej(pA,tA,mA)\nmovel(pB,tA,mA)",
            "pA.config.elbow=epositive\npB.config.elbow=efree\nmovej(pA,tA,mA)\nmovel(pB,tA,mA)",
            "pA.config.elbow=epositive\npB.config.wrist=wnegative\nmovej(pA,tA,mA)\nmovel(pB,tA,mA)",
        ];
        for line in lines {
            assert_eq!(check(&RULE, &program(line)), "", "{line}");
        }
    }

    #[test]
    fn unknown_configurations_are_not_reported() {
        let lines = [
            "movej(pB,tA,mA)",
            "movej(pA,tA,mA)\nmovej(pB,tA,mA)\nmovel(pB,tA,mA)",
            "if bA\nmovej(pA,tA,mA)\nendIf\nmovel(pB,tA,mA)",
            "movej(pA,tA,mA)\nresetMotion()\nmovel(pB,tA,mA)",
        ];
        for line in lines {
            assert_eq!(check(&RULE, &program(&format!("{SET}{line}"))), "", "{line}");
        }
    }
}
