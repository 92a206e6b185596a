use crate::declare::instruction;

instruction! {
    /// Loads a library under an identifier of the application.
    ///
    /// - `sPath`: where it is: `root://folder/name`. The root is `Disk` (the default), `USB0` or a network connection;
    ///   `./` starts at the application. An encrypted library is a `.zip` file.
    /// - `sPassword`: the public password of an encrypted library.
    /// - Result: 0 loaded; 11 loaded, but its interface differs from the declared one (what is missing raises error
    ///   80 when it is used); every other number says why nothing was loaded.
    ///
    /// It never raises a run-time error. Two identifiers that load the same library share its data.
    ///
    /// ## Example
    /// ```val3
    /// library part "Disk://part/part.pjx" autoload=false
    /// num nCode
    ///   nCode=part:libLoad("Disk://bolt")
    ///   if nCode!=0
    ///     logMsg("part not loaded: "+toString("",nCode))
    ///   endIf
    /// --- part
    /// public num nWeight
    /// --- bolt
    /// public num nWeight
    /// ```
    "libLoad": Libraries "6.7", blocking;
    modifier (string sPath) -> num on library;
    modifier (string sPath, string sPassword) -> num on library;
}
