//! `delay` (5.10): waits for a time.

use crate::call::{Call, Flow};
use crate::declare::instruction;
use crate::ports::nanoseconds;

instruction! {
    /// Waits for a time.
    ///
    /// - `nSeconds`: seconds; with 0 or less, only the other tasks have their turn.
    ///
    /// A loop without another wait needs a `delay(0)`: otherwise it would use the time of the other tasks.
    ///
    /// ## Example
    /// ```val3
    /// dio doLamp
    ///   doLamp=true
    ///   delay(0.5)
    ///   doLamp=false
    /// ```
    "delay": Tasks "5.10", blocking;
    modifier (num nSeconds) = delay;
}

/// Passes the turn to the other tasks, even if the time is 0.
fn delay(call: &mut Call<'_>, seconds: f64) -> Flow {
    let time = nanoseconds(seconds);
    if call.is_first() || call.waited() < time { call.sleep(time) } else { Flow::Done(()) }
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[test]
    fn waits_for_its_time() {
        let mut bench = Bench::default().at(2_000_000_000);
        assert_eq!(bench.run("delay(0.5)"), "sleeps until 2.5");
        bench.now = 2_499_999_999;
        assert_eq!(bench.run("delay(0.5)"), "sleeps until 2.5");
        bench.now = 2_500_000_000;
        assert_eq!(bench.run("delay(0.5)"), "");
    }

    #[test]
    fn zero_and_less_pass_the_turn_once() {
        for line in ["delay(0)", "delay(-1)"] {
            let mut bench = Bench::default().at(2_000_000_000);
            assert_eq!([bench.run(line), bench.run(line)], ["sleeps until 2", ""]);
        }
    }
}
