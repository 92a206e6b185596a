//! Times by limit of the arm's speed, and the resulting advice.

use std::collections::BTreeMap;

use serde::Serialize;
use val3_lang::ports::Time;
use val3_machine::event::seconds;
use val3_motion::SpeedLimit;

/// Limits that the table omits, because they only repeat the activity of the arm.
const REPEATED: [SpeedLimit; 6] = [
    SpeedLimit::Stop,
    SpeedLimit::Connection,
    SpeedLimit::Force,
    SpeedLimit::NextMove,
    SpeedLimit::Fault,
    SpeedLimit::End,
];

/// Limits of a stopped arm.
const AT_REST: [SpeedLimit; 4] = [SpeedLimit::NextMove, SpeedLimit::Fault, SpeedLimit::Held, SpeedLimit::End];

/// Minimum share of a line's time for a limit in the table, in per cent.
const LEAST: f64 = 1.0;

/// Time by limit, in nanoseconds.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct LimitTimes(BTreeMap<SpeedLimit, Time>);

/// Time share of a limit as JSON.
#[derive(Serialize)]
pub(super) struct LimitShare {
    #[serde(serialize_with = "name")]
    limit: SpeedLimit,
    seconds: f64,
    /// Percentage of the line's time.
    share: f64,
}

fn name<S: serde::Serializer>(limit: &SpeedLimit, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(limit)
}

impl LimitTimes {
    pub(super) fn add(&mut self, limit: SpeedLimit, time: Time) {
        *self.0.entry(limit).or_default() += time;
    }

    pub(super) fn extend(&mut self, other: &Self) {
        other.0.iter().for_each(|(limit, time)| self.add(*limit, *time));
    }

    pub(super) fn total(&self) -> Time {
        self.0.values().sum()
    }

    /// Limits with their times, longest time first.
    pub(super) fn shares(&self) -> Vec<LimitShare> {
        let total = self.total() as f64;
        let mut times: Vec<_> = self.0.iter().filter(|(_, time)| **time > 0).collect();
        times.sort_by_key(|(_, time)| std::cmp::Reverse(**time));
        times
            .into_iter()
            .map(|(limit, time)| (*limit, *time))
            .map(|(limit, time)| LimitShare { limit, seconds: seconds(time), share: time as f64 * 100.0 / total })
            .collect()
    }

    /// Limit that applied for most of the time with a move, and a suggestion; `None` if the arm never had a move.
    pub(super) fn advice(&self) -> Option<String> {
        let with_move = self.0.iter().filter(|(limit, _)| **limit != SpeedLimit::End);
        let (limit, time) = with_move.max_by_key(|(_, time)| **time).filter(|(_, time)| **time > 0)?;
        if AT_REST.contains(limit) {
            return Some(format!("the arm rests for {:.3} s {}", seconds(*time), remedy(*limit)));
        }
        let moving = self.0.iter().filter(|(limit, _)| !AT_REST.contains(limit)).map(|(_, time)| time).sum::<Time>();
        let share = *time as f64 * 100.0 / moving as f64;
        Some(format!("{share:.0} % of the moving time is limited by {}", remedy(*limit)))
    }
}

/// End of a sentence about the limit: its name and a suggestion.
fn remedy(limit: SpeedLimit) -> String {
    let of_axis = |axis: usize| format!("shorten the way of axis {}", axis + 1);
    match limit {
        SpeedLimit::Acceleration(axis) => format!("the {limit}: raise accel, or {}", of_axis(axis)),
        SpeedLimit::Deceleration(axis) => format!("the {limit}: raise decel, or {}", of_axis(axis)),
        SpeedLimit::AxisSpeed(axis) => format!("the {limit}: raise vel, or {}", of_axis(axis)),
        SpeedLimit::Translation => format!("{limit}: raise it in the motion descriptor"),
        SpeedLimit::Rotation => format!("{limit}: raise it in the motion descriptor, or turn the tool less"),
        SpeedLimit::Corner => "blends that bend sharply: raise leave and reach".to_owned(),
        SpeedLimit::ReducedSpeed => "the reduced speed in manual mode: compare times in remote mode".to_owned(),
        SpeedLimit::MonitorSpeed => format!("the {limit}: raise it to 100 %"),
        SpeedLimit::Stop => "stops: keep the arm moving, without stopMove and with power".to_owned(),
        SpeedLimit::Connection => "connection moves: stop the arm on its path, so that it needs none".to_owned(),
        SpeedLimit::Force => "the force of compliant moves: raise the force".to_owned(),
        SpeedLimit::Alter => "deviations at rest: alter the path while the arm moves along it".to_owned(),
        SpeedLimit::NextMove => "and waits for its next move: record moves earlier".to_owned(),
        SpeedLimit::Fault => "before a path that it cannot follow: correct the move".to_owned(),
        SpeedLimit::Held => "because it is held: look for stops, missing power and the step mode".to_owned(),
        SpeedLimit::End => "without a move: record moves earlier".to_owned(),
    }
}

/// Cell of the table.
pub(super) fn cell(shares: &[LimitShare]) -> String {
    let shown = shares.iter().filter(|one| one.share >= LEAST && !REPEATED.contains(&one.limit));
    shown.map(|one| format!("{:.0} % {}", one.share, one.limit)).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    const MS: Time = 1_000_000;

    fn times(times: &[(SpeedLimit, Time)]) -> LimitTimes {
        let mut all = LimitTimes::default();
        times.iter().for_each(|(limit, time)| all.add(*limit, time * MS));
        all
    }

    #[test]
    fn the_greatest_share_is_first_and_repetitions_are_omitted() {
        let shares = times(&[
            (SpeedLimit::Acceleration(2), 300),
            (SpeedLimit::Translation, 596),
            (SpeedLimit::Corner, 4),
            (SpeedLimit::Stop, 100),
        ])
        .shares();
        expect!["60 % tvel, 30 % acceleration of axis 3"].assert_eq(&cell(&shares));
        assert_eq!(shares.iter().map(|one| one.share).sum::<f64>(), 100.0);
    }

    #[test]
    fn the_advice_names_the_limit_of_most_of_the_time_with_a_move() {
        let advice =
            |limit| times(&[(limit, 300), (SpeedLimit::Corner, 100), (SpeedLimit::End, 900)]).advice().unwrap();
        let all = SpeedLimit::all().filter(|limit| *limit != SpeedLimit::End);
        let sentences: Vec<String> = all.filter(has_one_axis).map(|limit| advice(limit) + "\n").collect();
        expect![[r#"
            75 % of the moving time is limited by the acceleration of axis 2: raise accel, or shorten the way of axis 2
            75 % of the moving time is limited by the deceleration of axis 2: raise decel, or shorten the way of axis 2
            75 % of the moving time is limited by the speed of axis 2: raise vel, or shorten the way of axis 2
            75 % of the moving time is limited by tvel: raise it in the motion descriptor
            75 % of the moving time is limited by rvel: raise it in the motion descriptor, or turn the tool less
            100 % of the moving time is limited by blends that bend sharply: raise leave and reach
            75 % of the moving time is limited by the reduced speed in manual mode: compare times in remote mode
            75 % of the moving time is limited by the monitor speed: raise it to 100 %
            75 % of the moving time is limited by stops: keep the arm moving, without stopMove and with power
            75 % of the moving time is limited by connection moves: stop the arm on its path, so that it needs none
            75 % of the moving time is limited by the force of compliant moves: raise the force
            75 % of the moving time is limited by deviations at rest: alter the path while the arm moves along it
            the arm rests for 0.300 s and waits for its next move: record moves earlier
            the arm rests for 0.300 s before a path that it cannot follow: correct the move
            the arm rests for 0.300 s because it is held: look for stops, missing power and the step mode
        "#]]
        .assert_eq(&sentences.concat());
        assert_eq!(times(&[(SpeedLimit::End, 900)]).advice(), None);
    }

    /// Whether the limit belongs to axis 2 or to no axis.
    fn has_one_axis(limit: &SpeedLimit) -> bool {
        let text = limit.to_string();
        !text.contains("axis") || text.ends_with('2')
    }
}
