//! `setProfile` (4.3): activates another user profile.

use crate::call::{Call, Flow};
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Activates another user profile.
    ///
    /// - `sUserLogin`: its name.
    /// - `sUserPassword`: its password.
    /// - Result: 0 done, 1 no such profile, 2 wrong password, 3 the profile `staubli` cannot be chosen this way, 4 the
    ///   profile `staubli` is active and cannot be left this way.
    ///
    /// ## Example
    /// ```val3
    /// string sPassword
    ///   if setProfile("operator",sPassword)!=0
    ///     popUpMsg("Profile not changed")
    ///   endIf
    /// ```
    "setProfile": Screen "4.3", blocking;
    modifier (string sUserLogin, string sUserPassword) -> num = set_profile;
}

/// Passes the turn to the other tasks first, because profiles are files of the controller (5.4).
fn set_profile(call: &mut Call<'_>, login: Text, password: Text) -> Flow<f64> {
    if call.is_first() {
        return call.sleep(0);
    }
    Flow::Done(call.ports.set_profile(&login, &password).into())
}
