//! `getCS8Compatibility`.

use val3_soap::SoapFault;
use val3_soap::v0::{GetCs8Compatibility, GetCs8CompatibilityAnswer};

use crate::context::Context;
use crate::inferred::compatibility;

/// Answers the request.
pub(super) fn answer(
    _: &GetCs8Compatibility,
    context: &mut Context<'_, '_>,
) -> Result<GetCs8CompatibilityAnswer, SoapFault> {
    let version = context.controller().devices.state.versions.version("VAL 3");
    Ok(GetCs8CompatibilityAnswer { compatibility: compatibility(version) })
}
