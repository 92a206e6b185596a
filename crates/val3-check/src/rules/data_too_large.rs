//! V0539: data that need more memory than a controller has.

use val3_analysis::problem::DataSize;
use val3_lang::memory::MEMORY;

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// An array, or all data of a file together, need more memory than a controller has.
    ///
    /// ## Why
    /// All values of global data exist as soon as the application is in memory. Controllers have some hundred
    /// megabytes; `val3` assumes 512 MB, of which a number needs 8 bytes and a point 72. With larger data the
    /// application cannot be loaded, and `val3 run` rejects it.
    ///
    /// ## Bad
    /// ```val3
    /// num nSamples[100000000]
    ///
    /// nSamples[0]=1
    /// putln(nSamples[0])
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nSamples[10000]
    ///
    /// nSamples[0]=1
    /// putln(nSamples[0])
    /// ```
    V0539 "data-too-large" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(DataSize { name, bytes, total }: &DataSize) -> Wording {
    let (limit, help) = (megabytes(MEMORY), "reduce array sizes, or read large data from files");
    if *bytes > MEMORY {
        let message = format!("`{name}` needs {} MB, and a controller has {limit} MB for all data", megabytes(*bytes));
        return Wording::new(message, "too large for a controller", help);
    }
    let message = format!(
        "with `{name}` the data of this file need {} MB, and a controller has {limit} MB for all data",
        megabytes(*total)
    );
    Wording::new(message, "too large together with the data before it", help)
}

/// Megabytes of 2^20 bytes, rounded up.
fn megabytes(bytes: u64) -> u64 {
    bytes.div_ceil(1 << 20)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    fn worded(name: &str, bytes: u64, total: u64) -> String {
        word(&DataSize { name: name.into(), bytes, total }).to_string()
    }

    #[test]
    fn a_large_array_is_reported_with_its_size() {
        expect![[r#"
            `nSamples` needs 763 MB, and a controller has 512 MB for all data
            | too large for a controller
            ? reduce array sizes, or read large data from files
        "#]]
        .assert_eq(&worded("nSamples", 800_000_000, 800_000_000));
    }

    #[test]
    fn data_that_are_too_large_together_are_reported() {
        expect![[r#"
            with `nB` the data of this file need 763 MB, and a controller has 512 MB for all data
            | too large together with the data before it
            ? reduce array sizes, or read large data from files
        "#]]
        .assert_eq(&worded("nB", 400_000_000, 800_000_000));
    }
}
