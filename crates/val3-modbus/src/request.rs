//! Executes requests on the image.

mod check;

use modbus_core::tcp::server::encode_response;
use modbus_core::tcp::{Header, ResponseAdu};
use modbus_core::{Coils, Data, Error, Exception, ExceptionResponse, FunctionCode, Request, Response, ResponsePdu};

use crate::image::BeyondTable;
use crate::{Message, ModbusImage, TableKind};

/// Code of *Mask Write Register*, which `modbus-core` decodes as a custom function.
const MASK_WRITE: u8 = 22;

impl From<BeyondTable> for Exception {
    fn from(BeyondTable: BeyondTable) -> Self {
        Self::IllegalDataAddress
    }
}

/// Executes a request, and returns the message with the response or the exception.
///
/// # Errors
/// The response cannot be encoded.
pub fn respond(message: &Message, image: &mut ModbusImage) -> Result<Vec<u8>, Error> {
    let hdr = Header { transaction_id: message.transaction, unit_id: message.unit };
    let mut values = [0; Message::MAX_BYTES];
    let response = execute(&message.request, image, &mut values);
    let function = FunctionCode::new(message.request.first().copied().unwrap_or_default());
    let pdu = ResponsePdu(response.map_err(|exception| ExceptionResponse { function, exception }));
    let mut bytes = vec![0; Message::MAX_BYTES];
    let size = encode_response(ResponseAdu { hdr, pdu }, &mut bytes)?;
    bytes.truncate(size);
    Ok(bytes)
}

/// Executes the ten functions for bits and words; `values` receives the values that are read.
fn execute<'a>(request: &'a [u8], image: &mut ModbusImage, values: &'a mut [u8]) -> Result<Response<'a>, Exception> {
    check::check(request)?;
    let illegal = |_| Exception::IllegalDataValue;
    match Request::try_from(request).map_err(illegal)? {
        Request::ReadCoils(first, count) => bits(image, first, count, values).map(Response::ReadCoils),
        Request::ReadDiscreteInputs(first, count) => {
            bits(image, first, count, values).map(Response::ReadDiscreteInputs)
        }
        Request::ReadHoldingRegisters(first, count) => {
            words(image, first, count, values).map(Response::ReadHoldingRegisters)
        }
        Request::ReadInputRegisters(first, count) => {
            words(image, first, count, values).map(Response::ReadInputRegisters)
        }
        Request::WriteSingleCoil(address, value) => {
            image.write(TableKind::Bits, address, &[u16::from(value)])?;
            // The response repeats the request. `Response::WriteSingleCoil` has no value.
            Ok(Response::Custom(FunctionCode::WriteSingleCoil, request.get(1..).unwrap_or_default()))
        }
        Request::WriteSingleRegister(address, value) => {
            image.write(TableKind::Words, address, &[value])?;
            Ok(Response::WriteSingleRegister(address, value))
        }
        Request::WriteMultipleCoils(first, coils) => {
            let written: Vec<u16> = coils.into_iter().map(u16::from).collect();
            image.write(TableKind::Bits, first, &written)?;
            Ok(Response::WriteMultipleCoils(first, count(coils.len())?))
        }
        Request::WriteMultipleRegisters(first, data) => {
            image.write(TableKind::Words, first, &data.into_iter().collect::<Vec<_>>())?;
            Ok(Response::WriteMultipleRegisters(first, count(data.len())?))
        }
        Request::ReadWriteMultipleRegisters(first, count, target, data) => {
            image.read(TableKind::Words, first, count)?;
            image.write(TableKind::Words, target, &data.into_iter().collect::<Vec<_>>())?;
            words(image, first, count, values).map(Response::ReadWriteMultipleRegisters)
        }
        Request::Custom(FunctionCode::Custom(MASK_WRITE), masks) => {
            write_masked(image, masks)?;
            Ok(Response::Custom(FunctionCode::MaskWriteRegister, masks))
        }
        Request::Custom(..) => Err(Exception::IllegalFunction),
    }
}

/// Replaces the bits of a word outside the first mask by the bits of the second mask.
fn write_masked(image: &mut ModbusImage, request: &[u8]) -> Result<(), Exception> {
    let fields: Vec<u16> =
        request.chunks_exact(2).map(|pair| pair.iter().fold(0, |word, byte| word << 8 | u16::from(*byte))).collect();
    let &[address, kept, new] = fields.as_slice() else { return Err(Exception::IllegalDataValue) };
    let value: u16 = image.read(TableKind::Words, address, 1)?.into_iter().sum();
    Ok(image.write(TableKind::Words, address, &[value & kept | new & !kept])?)
}

fn bits<'a>(image: &mut ModbusImage, first: u16, count: u16, target: &'a mut [u8]) -> Result<Coils<'a>, Exception> {
    let values: Vec<bool> = image.read(TableKind::Bits, first, count)?.into_iter().map(|bit| bit != 0).collect();
    Coils::from_bools(&values, target).map_err(|_| Exception::ServerDeviceFailure)
}

fn words<'a>(image: &mut ModbusImage, first: u16, count: u16, target: &'a mut [u8]) -> Result<Data<'a>, Exception> {
    let values = image.read(TableKind::Words, first, count)?;
    Data::from_words(&values, target).map_err(|_| Exception::ServerDeviceFailure)
}

fn count(values: usize) -> Result<u16, Exception> {
    u16::try_from(values).map_err(|_| Exception::IllegalDataValue)
}

#[cfg(test)]
mod tests;
