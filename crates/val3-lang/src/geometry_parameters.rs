//! Geometric parameters of the arm in the arrays of `getDH`, `getDefaultDH` and `setDH` (11.4.4).

use val3_kinematics::Dh;

use crate::call::{Arr, Call};
use crate::fault::{Fault, Result};
use crate::runtime_errors::INVALID_PARAMETER;

/// Writes parameters to `theta`, `d`, `a`, `alpha`, `beta`. The flange's `d` is written if the array has room for it.
///
/// # Errors
/// 70 if an array has fewer values than the arm has axes.
pub(crate) fn write(call: &mut Call<'_>, dh: &Dh, arrays: [Arr<f64>; 5]) -> Result<()> {
    let axes = call.ports.arm().axes();
    let [theta, d, a, alpha, beta] = arrays;
    for array in [&theta, &d, &a, &alpha, &beta] {
        if array.len(call)? < axes {
            return Err(Fault(INVALID_PARAMETER));
        }
    }
    let count = d.len(call)?.min(axes + 1);
    d.set_all(call, dh.d.into_iter().take(count))?;
    for (array, values) in [(&theta, dh.theta), (&a, dh.a), (&alpha, dh.alpha), (&beta, dh.beta)] {
        array.set_all(call, values.into_iter().take(axes))?;
    }
    Ok(())
}

/// Reads `theta`, `d`, `a`, `b`, `alpha`, `beta`: one value for each axis, and one more in `d`. `None` for other sizes.
///
/// # Errors
/// 20 if an array does not exist.
pub(crate) fn read(call: &mut Call<'_>, arrays: [Arr<f64>; 6]) -> Result<Option<Dh>> {
    let axes = call.ports.arm().axes();
    let mut dh = call.ports.arm().default_dh();
    let [theta, d, a, b, alpha, beta] = arrays;
    let columns = [
        (theta, axes, &mut dh.theta[..]),
        (d, axes + 1, &mut dh.d[..]),
        (a, axes, &mut dh.a[..]),
        (b, axes, &mut dh.b[..]),
        (alpha, axes, &mut dh.alpha[..]),
        (beta, axes, &mut dh.beta[..]),
    ];
    for (array, size, column) in columns {
        if array.len(call)? != size {
            return Ok(None);
        }
        for (value, given) in column.iter_mut().zip(array.all(call)?) {
            *value = given;
        }
    }
    Ok(Some(dh))
}
