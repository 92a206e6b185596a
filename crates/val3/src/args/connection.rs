//! Arguments of commands that connect to a controller by its address.

use val3_controller::CertificateFingerprint;

/// Arguments of the connection.
#[derive(Debug, Default, clap::Args)]
pub(crate) struct ConnectionArgs {
    /// Accept the server's certificate with this SHA-256 fingerprint, for an address `ftps://`. `val3 pull` remembers it
    #[arg(help_heading = "Connection", long, value_name = "FINGERPRINT")]
    pub(crate) fingerprint: Option<CertificateFingerprint>,
    /// Let the controller open the data connections to this computer (active mode). `val3 pull` remembers it
    #[arg(help_heading = "Connection", long, conflicts_with = "passive")]
    pub(crate) active: bool,
    /// Open the data connections from this computer, which is the default, although --active is remembered
    #[arg(help_heading = "Connection", long)]
    pub(crate) passive: bool,
}

impl ConnectionArgs {
    /// First used option; `None` if there is none.
    pub(crate) fn used(&self) -> Option<&'static str> {
        let options =
            [(self.fingerprint.is_some(), "--fingerprint"), (self.active, "--active"), (self.passive, "--passive")];
        options.into_iter().find_map(|(is_used, name)| is_used.then_some(name))
    }
}
