//! `ioStatus`: returns whether an input or output works.

use crate::call::{Call, IoRef, Var};
use crate::declare::instruction;
use crate::fault::Result;
use crate::types::BaseType;
use crate::values::Text;

instruction! {
    /// Returns whether an input or output works.
    ///
    /// - `diInputOutput`, `aiInputOutput`: the signal.
    /// - `sDescription`: receives its description.
    /// - `sPhysicalPath`: receives the path to which it is linked, usually `device\module\address`.
    /// - Result: 0 it works, 1 it is held at a value by the operator, 2 it is simulated in software, -1 no link, -2 no
    ///   such device or signal, -3 its device has failed.
    ///
    /// It never raises an error, so it can be called before the signal is used.
    ///
    /// ## Example
    /// ```val3
    /// dio diGripped
    /// string sText
    /// string sPath
    ///   if ioStatus(diGripped,sText,sPath)<0
    ///     logMsg(sPath+" failed: "+sText)
    ///   endIf
    /// ```
    "ioStatus": Io "3.5.3, 3.6.2";
    function (dio diInputOutput) -> num = of_digital;
    modifier (dio diInputOutput, string& sDescription, string& sPhysicalPath) -> num = describe_digital;
    function (aio aiInputOutput) -> num = of_analog;
    modifier (aio aiInputOutput, string& sDescription, string& sPhysicalPath) -> num = describe_analog;
}

fn of_digital(call: &mut Call<'_>, signal: IoRef) -> f64 {
    call.ports.io_status(BaseType::Dio, signal.port).into()
}

fn of_analog(call: &mut Call<'_>, signal: IoRef) -> f64 {
    call.ports.io_status(BaseType::Aio, signal.port).into()
}

fn describe_digital(call: &mut Call<'_>, signal: IoRef, description: Var<Text>, path: Var<Text>) -> Result<f64> {
    describe(call, signal, &description, &path)?;
    Ok(of_digital(call, signal))
}

fn describe_analog(call: &mut Call<'_>, signal: IoRef, description: Var<Text>, path: Var<Text>) -> Result<f64> {
    describe(call, signal, &description, &path)?;
    Ok(of_analog(call, signal))
}

fn describe(call: &mut Call<'_>, signal: IoRef, description: &Var<Text>, path: &Var<Text>) -> Result<()> {
    let found = call.ports.io_texts(signal.port);
    description.set(call, found.description)?;
    path.set(call, found.path)
}
