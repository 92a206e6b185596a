//! `getRecords`: this controller has no recorder.

use val3_soap::SoapFault;
use val3_soap::v1::{GetRecords, GetRecordsAnswer};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &GetRecords, _: &mut Context<'_, '_>) -> Result<GetRecordsAnswer, SoapFault> {
    Ok(GetRecordsAnswer { records: Vec::new() })
}
