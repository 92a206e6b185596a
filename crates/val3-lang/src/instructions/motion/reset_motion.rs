use crate::declare::instruction;

instruction! {
    /// Stops the arm and forgets every recorded move.
    ///
    /// - `jStartingPoint`: where the next move starts: the arm first has to get there by a connection move. Without it,
    ///   the next move starts wherever the arm is.
    ///
    /// It returns at once, sets the move id to 0 and undoes a `stopMove`.
    ///
    /// ## Example
    /// ```val3
    ///   if isEmpty()==false
    ///     resetMotion()
    ///     putln("moves cancelled")
    ///   endIf
    /// ```
    "resetMotion": Motion "10.6";
    modifier ();
    modifier (joint jStartingPoint);
}
