//! `abs`: returns the absolute value of a number, or absolute axis values of a joint position.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::{JointValue, numbers};

instruction! {
    /// Returns the absolute value of a number, or the absolute axis values of a joint position.
    ///
    /// - `nValue`, `jPosition`: the value, which may be negative.
    /// - Result: the absolute value; for a joint position, in degrees and millimetres (inches).
    ///
    /// `abs(jA-jB)<jTolerance` is `true` if every axis is closer than its tolerance.
    ///
    /// ## Example
    /// ```val3
    /// joint jPark
    /// joint jTolerance
    ///   jTolerance={2,2,2,5,5,5}
    ///   if abs(herej()-jPark)<jTolerance
    ///     putln("in park position")
    ///   endIf
    /// ```
    "abs": Numbers "3.2.3, 9.2.3";
    function (num nValue) -> num = of_number;
    function (joint jPosition) -> joint = of_joint;
}

fn of_number(_: &mut Call<'_>, value: f64) -> f64 {
    numbers::abs(value)
}

fn of_joint(_: &mut Call<'_>, JointValue(position): JointValue) -> JointValue {
    JointValue(position.map(numbers::abs))
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("abs(3.1415)", "3.1415");
        check("abs(-3.1415)", "3.1415");
        check("abs({-1,2,-3,0,-0.5,6})", "{1,2,3,0,0.5,6}");
    }
}
