//! Messages of Modbus TCP: a header of 7 bytes (MBAP) and a request.

/// Size of the header up to and with its length.
const PREFIX: usize = 6;

/// Permitted lengths of unit and request in bytes: at least a function, at most 253 bytes of a request.
const LENGTHS: std::ops::RangeInclusive<usize> = 2..=254;

/// Functions up to this number are requests; greater numbers are exceptions.
const LAST_FUNCTION: u8 = 0x7F;

/// Received request, with the header fields that the response repeats.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    pub(crate) transaction: u16,
    pub(crate) unit: u8,
    /// Function and its data, not empty.
    pub(crate) request: Vec<u8>,
}

/// The bytes are no Modbus message, so the next message cannot be found either.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotModbus;

impl Message {
    /// Greatest size of a message in bytes.
    pub const MAX_BYTES: usize = PREFIX + *LENGTHS.end();

    /// Removes the first message from the received bytes; `None` if it is not complete yet.
    ///
    /// # Errors
    /// The bytes are no Modbus message.
    pub fn take(received: &mut Vec<u8>) -> Result<Option<Self>, NotModbus> {
        if received.get(2..4).is_some_and(|protocol| protocol != [0, 0]) {
            return Err(NotModbus);
        }
        let Some((&[transaction_high, transaction_low, _, _, high, low], _)) = received.split_first_chunk::<PREFIX>()
        else {
            return Ok(None);
        };
        let length = usize::from(u16::from_be_bytes([high, low]));
        if !LENGTHS.contains(&length) {
            return Err(NotModbus);
        }
        let Some([unit, request @ ..]) = received.get(PREFIX..PREFIX + length) else { return Ok(None) };
        if request.first().is_none_or(|function| *function > LAST_FUNCTION) {
            return Err(NotModbus);
        }
        let transaction = u16::from_be_bytes([transaction_high, transaction_low]);
        let message = Self { transaction, unit: *unit, request: request.to_vec() };
        received.drain(..PREFIX + length);
        Ok(Some(message))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn messages_are_split() {
        let mut bytes = [0, 1, 0, 0, 0, 3, 255, 7, 9].repeat(2);
        bytes.pop();
        let first = Message::take(&mut bytes).unwrap().unwrap();
        assert_eq!((first.transaction, first.unit, &first.request[..]), (1, 255, &[7, 9][..]));
        assert_eq!((Message::take(&mut bytes), bytes.len()), (Ok(None), 8));
        bytes.push(9);
        assert_eq!((Message::take(&mut bytes), bytes.len()), (Ok(Some(first)), 0));
    }

    #[test]
    fn other_bytes_are_recognised_early() {
        for bytes in
            [&[0, 1, 0, 1][..], &[0, 1, 0, 0, 0, 1], &[0, 1, 0, 0, 0, 255], &[0, 1, 0, 0, 0, 2, 1, 0x81], b"GET /"]
        {
            assert_eq!(Message::take(&mut bytes.to_vec()), Err(NotModbus), "{bytes:?}");
        }
    }

    proptest! {
        #[test]
        fn any_bytes_are_split_without_panic(mut bytes in prop::collection::vec(any::<u8>(), 0..600)) {
            let before = bytes.len();
            match Message::take(&mut bytes) {
                Ok(Some(message)) => prop_assert_eq!(bytes.len() + message.request.len() + 7, before),
                Ok(None) | Err(NotModbus) => prop_assert_eq!(bytes.len(), before),
            }
        }
    }
}
