//! `getSoapServerVersion`.

use val3_soap::SoapFault;
use val3_soap::v0::{GetSoapServerVersion, GetSoapServerVersionAnswer, InterfaceVersion};

use crate::context::Context;
use crate::inferred::INTERFACE_VERSION;

/// Answers the request.
pub(super) fn answer(
    _: &GetSoapServerVersion,
    _: &mut Context<'_, '_>,
) -> Result<GetSoapServerVersionAnswer, SoapFault> {
    let version = Some(INTERFACE_VERSION.to_owned());
    Ok(GetSoapServerVersionAnswer { server: InterfaceVersion { version } })
}
