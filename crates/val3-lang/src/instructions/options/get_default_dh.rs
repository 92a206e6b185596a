//! `getDefaultDH` (11.4.4): gives the geometrical parameters that an arm of this type has by design.

use crate::declare::instruction;

instruction! {
    /// Gives the geometrical parameters that an arm of this type has by design.
    ///
    /// - `theta`, `alpha`, `beta`: get the angles, degrees, one value an axis.
    /// - `d`, `a`: get the lengths, millimetres, one value an axis.
    /// - Error 70: an array is too small.
    ///
    /// ## Example
    /// ```val3
    /// num nTheta[6]
    /// num nD[7]
    /// num nA[6]
    /// num nAlpha[6]
    /// num nBeta[6]
    ///   getDefaultDH(nTheta,nD,nA,nAlpha,nBeta)
    ///   putln(nA[1])
    /// ```
    "getDefaultDH": Options "11.4.4", errors [70];
    modifier (num& theta[], num& d[], num& a[], num& alpha[], num& beta[]);
}
