use crate::declare::instruction;

instruction! {
    /// Reads bytes from a serial channel.
    ///
    /// - `siInput`: the serial line or socket; a socket that is not connected is opened first.
    /// - `nData`: gets the bytes, each 0 to 255. One variable gets one byte; of an array, an index may say where to
    ///   start. Reading ends when it is full or nothing more has come in.
    /// - Result: the number of bytes read; -1 if none came within the timeout of the channel.
    /// - Errors: 70 without a variable for the bytes, 123 not linked, 125 the channel has failed.
    ///
    /// It waits for the first byte; other tasks run on.
    ///
    /// ## Example
    /// ```val3
    /// sio siHost
    /// num nBytes[48]
    /// num nRead
    ///   nRead=sioGet(siHost,nBytes)
    ///   if nRead<0
    ///     logMsg("host is silent")
    ///   endIf
    /// ```
    "sioGet": Io "3.7.3", blocking, errors [70, 123, 125];
    modifier (sio siInput, num& nData[]) -> num;
}
