use crate::declare::instruction;

instruction! {
    /// Makes another user profile active.
    ///
    /// - `sUserLogin`: its name.
    /// - `sUserPassword`: its password.
    /// - Result: 0 done, 1 no such profile, 2 wrong password, 3 the profile `staubli` cannot be chosen this way,
    ///   4 the profile `staubli` is active and cannot be left this way.
    ///
    /// ## Example
    /// ```val3
    /// string sPassword
    ///   if setProfile("operator",sPassword)!=0
    ///     popUpMsg("Profile not changed")
    ///   endIf
    /// ```
    "setProfile": Screen "4.3", blocking;
    modifier (string sUserLogin, string sUserPassword) -> num;
}
