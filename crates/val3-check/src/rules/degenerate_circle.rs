//! V0418: a circle or frame that equal points cannot define.

use val3_analysis::body::ExprId;
use val3_lang::instructions::{ALTER_MOVEC, MOVEC, SET_FRAME};
use val3_lang::runtime_errors::IMPOSSIBLE_MOVE;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::{Severity, rule};

rule! {
    /// Two points of a circle, or two of the three points of a frame, are the same.
    ///
    /// ## Why
    /// `movec` goes through an intermediate point to a target. Without two different points there is no circle, which is
    /// run-time error 154 (10.6). `setFrame` computes a frame from three different points, otherwise it returns -1 and
    /// does not change the frame (9.4.4).
    ///
    /// ## Bad
    /// ```val3
    /// point pTop
    /// point pEnd
    /// tool tGripper
    /// mdesc mSlow
    ///
    /// movec(pEnd,pEnd,tGripper,mSlow)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pTop
    /// point pEnd
    /// tool tGripper
    /// mdesc mSlow
    ///
    /// movec(pTop,pEnd,tGripper,mSlow)
    /// ```
    V0418 "degenerate-circle" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for name in [MOVEC, ALTER_MOVEC, SET_FRAME] {
        for call in program.calls_of(name) {
            let mut points = call.args.to_vec();
            points.retain(|id| program.inference.ty(*id).base.builtin() == Some(BaseType::Point));
            let Some((first, second)) = equal_pair(program, &points) else { continue };
            let (wording, level) = if name == SET_FRAME {
                (word_frame(program.text(second)), Severity::Warning)
            } else {
                (word_circle(program.text(second)), Severity::Error)
            };
            found.report(&RULE, program.range(second), wording).level(level).related(program.range(first), "the same");
        }
    }
}

fn equal_pair(program: &ProgramView<'_>, points: &[ExprId]) -> Option<(ExprId, ExprId)> {
    let pairs =
        points.iter().enumerate().flat_map(|(at, second)| points.iter().take(at).map(move |first| (*first, *second)));
    pairs.into_iter().find(|(first, second)| program.is_same(*first, *second))
}

fn word_circle(point: &str) -> Wording {
    Wording::new(
        format!("`{point}` is both the intermediate point and the target of the circle"),
        runtime_error(IMPOSSIBLE_MOVE),
        "teach an intermediate point, or use `movel`",
    )
}

fn word_frame(point: &str) -> Wording {
    Wording::new(
        format!("`{point}` is two of the three points of the frame"),
        "the frame does not change",
        "use three points that are not in line",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn program(code: &str) -> String {
        check(&RULE, &format!("point pA\npoint pB\npoint pC[3]\nframe fA\ntool tA\nmdesc mA\nnum nA\n{code}"))
    }

    #[test]
    fn equal_points_are_reported() {
        expect![[r#"
            start.pgx:5 `(pC[1])` `(pC[1])` is both the intermediate point and the target of the circle
              | run-time error 154: move not possible
              ? teach an intermediate point, or use `movel`
              > start.pgx:5 `pC[1]` the same
            start.pgx:6 `pA` `pA` is two of the three points of the frame
              | the frame does not change
              ? use three points that are not in line
              > start.pgx:6 `pA` the same
        "#]]
        .assert_eq(&program("movec(pC[1],(pC[1]),tA,mA)\nnA=setFrame(pA,pB,pA,fA)"));
    }

    #[test]
    fn different_points_are_not_reported() {
        assert_eq!(program("movec(pA,pB,tA,mA)\nmovec(pC[0],pC[1],tA,mA)\nnA=setFrame(pA,pB,pC[0],fA)"), "");
        assert_eq!(program("movec(appro(pA,{0,0,1,0,0,0}),appro(pA,{0,0,1,0,0,0}),tA,mA)"), "");
    }
}
