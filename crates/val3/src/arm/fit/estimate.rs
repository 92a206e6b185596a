//! Least-squares estimation of axis speed, acceleration and deceleration from move times.

use nalgebra::{Matrix4, Vector4};

use super::log::Move;

/// Standard deviation, in seconds, of a time that is rounded to cycles of 4 ms. Smaller residuals are not significant.
const CYCLE_DEVIATION: f64 = 0.004 / 3.464;

/// Number of reweighting rounds, in which interrupted moves lose their influence.
const ROUNDS: usize = 8;

/// Maximum number of steps in one minimisation.
const STEPS: usize = 200;

/// Number of standard deviations above which a residual is rejected.
const OUTLIER: f64 = 5.0;

/// Residual, in seconds, up to which a move is never rejected.
const TOLERANCE: f64 = 0.012;

/// Maximum share of rejected moves. A larger share means that the times do not belong to one axis in one state.
const MOST_REJECTED: f64 = 0.25;

/// Maximum relative standard uncertainty of a determined value.
const DETERMINED: f64 = 0.1;

/// Minimum part of a move at constant speed, for the move to determine the nominal speed.
const CONSTANT: f64 = 0.3;

/// Minimum number of moves that determine the nominal speed.
const FEWEST_CONSTANT: usize = 3;

/// Minimum number of moves for the computation of four values.
const FEWEST: usize = 8;

/// A value and its standard uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Estimate {
    /// The value.
    pub(super) value: f64,
    /// Standard uncertainty, in the unit of the value.
    pub(super) uncertainty: f64,
}

/// Axis times at 100 %, in degrees or mm, and seconds.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AxisTimes {
    /// Nominal speed.
    pub(super) speed: Estimate,
    /// Acceleration.
    pub(super) acceleration: Estimate,
    /// Deceleration.
    pub(super) deceleration: Estimate,
    /// Delay in seconds: between the instruction and the start of its move, plus between the end of the move and the
    /// return of the instruction.
    pub(super) delay: f64,
    /// Root mean square of the residuals, in seconds.
    pub(super) residual: f64,
    /// Number of used measurements.
    pub(super) moves: usize,
    /// Number of rejected measurements.
    pub(super) rejected: usize,
}

/// Reason why the times do not determine the axis values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Undetermined {
    /// The log contains no moves or too few moves.
    Few,
    /// Too many times contradict each other.
    Scattered,
    /// The moves are too similar or too short to determine this value.
    Value(&'static str),
}

/// Parameters: logarithms of speed, acceleration and deceleration, so that all are positive, and the delay in seconds.
type Parameters = Vector4<f64>;

/// Computes the axis times from measured moves.
pub(super) fn estimate(moves: &[Move]) -> Result<AxisTimes, Undetermined> {
    let mut parameters = start(moves).ok_or(Undetermined::Few)?;
    for _ in 0..ROUNDS {
        let scale = 2.0 * spread(moves, &parameters).max(CYCLE_DEVIATION);
        let weight = |one: &Move| 1.0 / (1.0 + (residual(one, &parameters) / scale).powi(2));
        let weighted: Vec<_> = moves.iter().map(|one| (*one, weight(one))).collect();
        parameters = minimise(&weighted, parameters);
    }
    let limit = (OUTLIER * spread(moves, &parameters)).max(TOLERANCE);
    let kept: Vec<_> = moves.iter().copied().filter(|one| residual(one, &parameters).abs() <= limit).collect();
    if kept.len() < FEWEST {
        return Err(Undetermined::Few);
    }
    let equal: Vec<_> = kept.iter().map(|one| (*one, 1.0)).collect();
    parameters = minimise(&equal, parameters);
    #[allow(clippy::cast_precision_loss, reason = "a log has far fewer lines")]
    let (count, rejected) = (kept.len() as f64, (moves.len() - kept.len()) as f64);
    if rejected > MOST_REJECTED * (count + rejected) {
        return Err(Undetermined::Scattered);
    }
    // Without moves at constant speed, the transition between the two formulas of the time would be mistaken for a
    // speed.
    if kept.iter().filter(|one| constant_part(one, &parameters) >= CONSTANT).count() < FEWEST_CONSTANT {
        return Err(Undetermined::Value("nominal speed"));
    }
    let squares: f64 = kept.iter().map(|one| residual(one, &parameters).powi(2)).sum();
    let deviation = (squares / (count - 4.0)).sqrt().max(CYCLE_DEVIATION);
    // The small addition keeps the matrix regular: a value without influence on any time gets a huge uncertainty.
    let covariance = (normal(&equal, &parameters).0 + Matrix4::identity() * 1e-12).try_inverse();
    let covariance = covariance.ok_or(Undetermined::Value("nominal speed"))? * deviation.powi(2);
    let variances = covariance.diagonal();
    Ok(AxisTimes {
        speed: determined(parameters.x, variances.x, "nominal speed")?,
        acceleration: determined(parameters.y, variances.y, "acceleration")?,
        deceleration: determined(parameters.z, variances.z, "deceleration")?,
        delay: parameters.w,
        residual: (squares / count).sqrt(),
        moves: kept.len(),
        rejected: moves.len() - kept.len(),
    })
}

/// Value with this logarithm, whose variance is the square of the value's relative uncertainty.
fn determined(logarithm: f64, variance: f64, name: &'static str) -> Result<Estimate, Undetermined> {
    let (value, relative) = (logarithm.exp(), variance.sqrt());
    let is_determined = value.is_finite() && relative <= DETERMINED;
    is_determined.then_some(Estimate { value, uncertainty: value * relative }).ok_or(Undetermined::Value(name))
}

/// Initial parameters: a high quantile of the mean speeds, and of the accelerations under the assumption that no move
/// has constant speed. Both are lower bounds of the true values, so that all times depend on both.
fn start(moves: &[Move]) -> Option<Parameters> {
    let speed = quantile(moves.iter().map(|one| one.length / one.seconds / one.vel))?;
    let rate = |one: &Move| 2.0 * one.length * (1.0 / one.accel + 1.0 / one.decel) / one.seconds.powi(2);
    let acceleration = quantile(moves.iter().map(rate))?;
    Some(Vector4::new(speed.ln(), acceleration.ln(), acceleration.ln(), 0.0))
}

fn quantile(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() * 9 / 10).copied()
}

/// Minimises the weighted sum of squared residuals by damped Gauss-Newton steps (Levenberg-Marquardt).
fn minimise(moves: &[(Move, f64)], start: Parameters) -> Parameters {
    let cost = |at: &Parameters| moves.iter().map(|(one, weight)| weight * residual(one, at).powi(2)).sum::<f64>();
    let (mut at, mut damping) = (start, 1e-3);
    let mut best = cost(&at);
    for _ in 0..STEPS {
        let (matrix, gradient) = normal(moves, &at);
        let damped = matrix + Matrix4::from_diagonal(&(matrix.diagonal().add_scalar(1e-12) * damping));
        let Some(step) = damped.lu().solve(&gradient) else { break };
        let next = at + step.map(|change| change.clamp(-1.0, 1.0));
        let found = cost(&next);
        if found < best {
            let has_converged = step.amax() < 1e-10;
            (at, best, damping) = (next, found, damping / 10.0);
            if has_converged {
                break;
            }
        } else {
            damping *= 10.0;
            if damping > 1e12 {
                break;
            }
        }
    }
    at
}

/// Matrix and right-hand side of the normal equations for weighted moves.
fn normal(moves: &[(Move, f64)], at: &Parameters) -> (Matrix4<f64>, Vector4<f64>) {
    moves.iter().fold((Matrix4::zeros(), Vector4::zeros()), |(matrix, gradient), (one, weight)| {
        let (time, slopes) = time(one, at);
        (matrix + slopes * slopes.transpose() * *weight, gradient + slopes * (one.seconds - time) * *weight)
    })
}

fn residual(one: &Move, at: &Parameters) -> f64 {
    one.seconds - time(one, at).0
}

/// Computes the time of a move and its derivatives with respect to the parameters. The move accelerates, has constant
/// speed if it reaches it, and decelerates.
fn time(one: &Move, at: &Parameters) -> (f64, Vector4<f64>) {
    let speed = at.x.exp() * one.vel;
    let gain = 1.0 / (at.y.exp() * one.accel);
    let loss = 1.0 / (at.z.exp() * one.decel);
    let ramps = speed * (gain + loss) / 2.0;
    if speed * ramps < one.length {
        let travel = one.length / speed;
        return (at.w + travel + ramps, Vector4::new(ramps - travel, -speed * gain / 2.0, -speed * loss / 2.0, 1.0));
    }
    let time = (2.0 * one.length * (gain + loss)).sqrt();
    let share = time / 2.0 / (gain + loss);
    (at.w + time, Vector4::new(0.0, -share * gain, -share * loss, 1.0))
}

/// Fraction of the length at constant speed; negative for a move that does not reach constant speed.
fn constant_part(one: &Move, at: &Parameters) -> f64 {
    let gain = 1.0 / (at.y.exp() * one.accel) + 1.0 / (at.z.exp() * one.decel);
    1.0 - (at.x.exp() * one.vel).powi(2) * gain / 2.0 / one.length
}

/// Robust standard deviation of the residuals, computed from the median so that outliers have no influence.
fn spread(moves: &[Move], at: &Parameters) -> f64 {
    let mut residuals: Vec<_> = moves.iter().map(|one| residual(one, at).abs()).collect();
    residuals.sort_by(f64::total_cmp);
    1.4826 * residuals.get(residuals.len() / 2).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Moves with these axis values; times are rounded up to cycles of 4 ms.
    fn moves(speed: f64, acceleration: f64, deceleration: f64, delay: f64) -> Vec<Move> {
        let at = Vector4::new(speed.ln(), acceleration.ln(), deceleration.ln(), delay);
        let mut moves = Vec::new();
        for (vel, accel, decel) in [
            (0.05, 1.0, 1.0),
            (0.1, 1.0, 1.0),
            (1.0, 0.05, 1.0),
            (1.0, 1.0, 0.05),
            (1.0, 0.1, 1.0),
            (1.0, 1.0, 0.1),
            (1.0, 1.0, 1.0),
        ] {
            for length in [30.0, 21.0, 17.0, 13.0] {
                let exact = Move { length, vel, accel, decel, seconds: 0.0 };
                let seconds = (time(&exact, &at).0 / 0.004).ceil() * 0.004;
                moves.push(Move { seconds, ..exact });
            }
        }
        moves
    }

    #[track_caller]
    fn check(found: &AxisTimes, [speed, acceleration, deceleration]: [f64; 3]) {
        for (estimate, true_value) in
            [(found.speed, speed), (found.acceleration, acceleration), (found.deceleration, deceleration)]
        {
            assert!((estimate.value / true_value - 1.0).abs() < 0.01, "{true_value}: {found:?}");
            assert!((estimate.value - true_value).abs() < 3.0 * estimate.uncertainty, "{true_value}: {found:?}");
        }
    }

    #[test]
    fn values_are_found_whatever_they_are() {
        for [speed, acceleration, deceleration] in
            [[287.1, 1435.5, 1435.5], [100.0, 300.0, 900.0], [700.0, 5000.0, 2000.0], [1300.0, 6600.0, 9000.0]]
        {
            let found = estimate(&moves(speed, acceleration, deceleration, 0.02)).unwrap();
            check(&found, [speed, acceleration, deceleration]);
            assert!((found.delay - 0.022).abs() < 0.003 && found.rejected == 0, "{found:?}");
        }
    }

    #[test]
    fn interrupted_moves_are_rejected() {
        let mut moves = moves(287.0, 1400.0, 1100.0, 0.0);
        moves[3].seconds += 20.0;
        moves[12].seconds += 0.1;
        moves[20].seconds = 0.004;
        let found = estimate(&moves).unwrap();
        assert_eq!((found.moves, found.rejected), (25, 3));
        check(&found, [287.0, 1400.0, 1100.0]);
    }

    #[test]
    fn moves_that_are_alike_determine_nothing() {
        let full: Vec<_> = moves(287.0, 1400.0, 1100.0, 0.0).into_iter().filter(|one| one.vel == 1.0).collect();
        assert_eq!(estimate(&full), Err(Undetermined::Value("nominal speed")));
        let slow: Vec<_> = moves(287.0, 1400.0, 1100.0, 0.0).into_iter().filter(|one| one.vel < 0.07).collect();
        assert_eq!(estimate(&slow), Err(Undetermined::Few));
        let same: Vec<_> = slow.iter().cycle().take(40).copied().collect();
        assert_eq!(estimate(&same), Err(Undetermined::Value("acceleration")));
        assert_eq!(estimate(&[]), Err(Undetermined::Few));
    }

    #[test]
    fn times_without_a_law_are_no_result() {
        let mut moves = moves(287.0, 1400.0, 1100.0, 0.0);
        for (place, one) in moves.iter_mut().enumerate() {
            one.seconds = [0.3, 1.0, 0.05, 2.0, 0.7][place % 5];
        }
        assert!(estimate(&moves).is_err());
    }
}
