//! `getRecord`: this controller has no recorder.

use val3_soap::v1::{GetRecord, GetRecordAnswer};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};

/// Answers the request.
pub(super) fn answer(_: &GetRecord, _: &mut Context<'_, '_>) -> Result<GetRecordAnswer, SoapFault> {
    Err(refused(ExceptionCode::FileNotFound, "this controller has no recordings"))
}
