//! Requested and effective blend distances for events, debuggers and pages.

use std::fmt;

use serde::Serialize;

/// Both ends of the blend around a move's destination.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct BlendEnds {
    /// Distance to the destination at which the blend begins; `None` without a blend.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leave: Option<BlendDistance>,
    /// Distance to the destination at which the blend ends; `None` without a blend, or before the next move determines it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reach: Option<BlendDistance>,
}

/// Distance of a blend end to the move's destination.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BlendDistance {
    /// Distance of the motion descriptor, in mm.
    pub requested: f64,
    /// Distance within which the arm rounds the corner, in mm.
    pub effective: f64,
    /// Reason why the effective distance is shorter; `None` if it is not.
    #[serde(flatten)]
    pub cut: Option<BlendCut>,
}

/// Reason why a blend is shorter than requested.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct BlendCut {
    /// Kind of reason.
    pub reason: CutReason,
    /// Program of the line that is the reason; `None` if the descriptor is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// Line in the program's file, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
}

/// Kind of reason for a shorter blend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub enum CutReason {
    /// The move is too short for its leave and the reach of the blend before it.
    SharedWithPrevious,
    /// The next move is too short for the reach and its own leave.
    SharedWithNext,
    /// A move is shorter than the distance.
    ShortMove,
    /// The other distance of the blend is 0.
    StopAtTarget,
    /// An instruction has ended the move at its destination, for example `waitEndMove`.
    Cancelled,
}

impl BlendEnds {
    /// Ends that are shorter than requested, with their names.
    pub fn cut(&self) -> impl Iterator<Item = (&'static str, &BlendDistance)> {
        let ends = [("leave", &self.leave), ("reach", &self.reach)];
        ends.into_iter().filter_map(|(name, end)| end.as_ref().filter(|end| end.cut.is_some()).map(|end| (name, end)))
    }

    /// Reason why the blend is shorter than requested: `leave 40 → 19.5 mm (shared with the reach of start:12)`.
    ///
    /// `None` if both ends are as requested.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        self.joined(|name, end| format!("{name} {end} ({})", end.reason(name).unwrap_or_default()))
    }

    /// The note without reasons: `leave 40 → 19.5 mm`.
    #[must_use]
    pub fn short_note(&self) -> Option<String> {
        self.joined(|name, end| format!("{name} {end}"))
    }

    fn joined(&self, text: impl Fn(&str, &BlendDistance) -> String) -> Option<String> {
        let ends: Vec<String> = self.cut().map(|(name, end)| text(name, end)).collect();
        (!ends.is_empty()).then(|| ends.join(", "))
    }
}

impl BlendDistance {
    /// Reason why the end with this name, `leave` or `reach`, is shorter than requested.
    #[must_use]
    pub fn reason(&self, name: &str) -> Option<String> {
        let cut = self.cut.as_ref()?;
        let place = cut.program.as_ref().zip(cut.line).map(|(program, line)| format!("{program}:{line}"));
        let line = |without: &str| place.clone().unwrap_or_else(|| without.to_owned());
        Some(match cut.reason {
            CutReason::SharedWithPrevious => format!("shared with the reach of {}", line("the move before")),
            CutReason::SharedWithNext => format!("shared with the leave of {}", line("the next move")),
            CutReason::ShortMove => format!("length of the move of {}", line("this line")),
            CutReason::StopAtTarget => {
                let other = if name == "leave" { "reach" } else { "leave" };
                format!("the arm stops at the target, because {other} is 0")
            }
            CutReason::Cancelled => format!("cancelled by {}", line("waitEndMove")),
        })
    }
}

/// `40 → 19.5 mm`, or `40 mm`.
impl fmt::Display for BlendDistance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", amount(self.requested))?;
        if self.cut.is_some() {
            write!(f, " → {}", amount(self.effective))?;
        }
        write!(f, " mm")
    }
}

/// A distance in tenths of a millimetre, without needless decimals.
fn amount(distance: f64) -> String {
    format!("{distance:.1}").trim_end_matches(".0").to_owned()
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use expect_test::expect;

    use super::*;

    fn end(requested: f64, effective: f64, reason: Option<CutReason>, line: Option<u32>) -> Option<BlendDistance> {
        let program = line.map(|_| "start".to_owned());
        Some(BlendDistance { requested, effective, cut: reason.map(|reason| BlendCut { reason, program, line }) })
    }

    #[test]
    fn reasons_are_worded_for_people() {
        let reasons = [
            (CutReason::SharedWithPrevious, Some(12)),
            (CutReason::SharedWithNext, Some(14)),
            (CutReason::ShortMove, Some(14)),
            (CutReason::StopAtTarget, None),
            (CutReason::Cancelled, Some(16)),
            (CutReason::Cancelled, None),
        ];
        let mut notes = String::new();
        for (reason, line) in reasons {
            let cut = end(40.0, 19.5, Some(reason), line);
            let ends = BlendEnds { leave: cut.clone(), reach: end(40.0, 40.0, None, None) };
            writeln!(notes, "{}", ends.note().unwrap()).unwrap();
            writeln!(notes, "{}", BlendEnds { leave: ends.reach, reach: cut }.note().unwrap()).unwrap();
        }
        expect![[r#"
            leave 40 → 19.5 mm (shared with the reach of start:12)
            reach 40 → 19.5 mm (shared with the reach of start:12)
            leave 40 → 19.5 mm (shared with the leave of start:14)
            reach 40 → 19.5 mm (shared with the leave of start:14)
            leave 40 → 19.5 mm (length of the move of start:14)
            reach 40 → 19.5 mm (length of the move of start:14)
            leave 40 → 19.5 mm (the arm stops at the target, because reach is 0)
            reach 40 → 19.5 mm (the arm stops at the target, because leave is 0)
            leave 40 → 19.5 mm (cancelled by start:16)
            reach 40 → 19.5 mm (cancelled by start:16)
            leave 40 → 19.5 mm (cancelled by waitEndMove)
            reach 40 → 19.5 mm (cancelled by waitEndMove)
        "#]]
        .assert_eq(&notes);
        assert_eq!(BlendEnds { leave: end(40.0, 40.0, None, None), reach: None }.note(), None);
    }

    #[test]
    fn the_reason_is_beside_the_distances() {
        let ends = BlendEnds {
            leave: end(40.0, 19.5, Some(CutReason::SharedWithPrevious), Some(12)),
            reach: end(40.0, 40.0, None, None),
        };
        expect![[r#"
            {
              "leave": {
                "requested": 40.0,
                "effective": 19.5,
                "reason": "sharedWithPrevious",
                "program": "start",
                "line": 12
              },
              "reach": {
                "requested": 40.0,
                "effective": 40.0
              }
            }"#]]
        .assert_eq(&serde_json::to_string_pretty(&ends).unwrap());
    }
}
