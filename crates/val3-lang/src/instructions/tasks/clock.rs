//! `clock` (5.10): returns the time since the start of the controller.

use crate::call::Call;
use crate::declare::instruction;
use crate::ports::SECOND;

instruction! {
    /// Returns the time since the controller was started.
    ///
    /// - Result: seconds, with a resolution of a millisecond. It is independent of the time of day.
    ///
    /// ## Example
    /// ```val3
    /// num nStart
    ///   nStart=clock()
    ///   waitEndMove()
    ///   putln(clock()-nStart)
    /// ```
    "clock": Tasks "5.10";
    function () -> num = clock;
}

/// Returns completed milliseconds.
fn clock(call: &mut Call<'_>) -> f64 {
    let milliseconds = call.now() / (SECOND / 1000);
    milliseconds as f64 / 1000.0
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[test]
    fn counts_milliseconds_in_seconds() {
        let mut bench = Bench::default();
        for (now, shown) in
            [(0, "0"), (999_999, "0"), (1_000_000, "0.001"), (1_500_000, "0.001"), (61_002_999_999, "61.002")]
        {
            bench.now = now;
            assert_eq!(bench.run("clock()"), shown, "at {now} ns");
        }
    }
}
