//! Clients of the controller's SOAP interface: their requests, answered between cycles.

use std::time::{Duration, Instant};

use val3_analysis::system::Disk;
use val3_service::{Accounts, Service, ServiceTarget};

use super::opening::ReadyApplication;
use crate::output::to_stderr;
use crate::soap::{PendingCall, SoapAddress, SoapPort};
use crate::user_error::UserError;

/// Maximum number of requests answered between two cycles. Further requests wait for the next cycle.
const CALLS_PER_CYCLE: usize = 32;

/// Clients of a run.
pub(super) struct Clients {
    port: SoapPort,
    service: Service,
    begin: Instant,
}

impl Clients {
    /// Starts the server before the run begins.
    ///
    /// # Errors
    /// The address cannot be used, or a profile of the cell cannot be read.
    pub(super) fn open(address: SoapAddress, ready: &ReadyApplication) -> Result<Self, UserError> {
        let profiles = ready.application.cell_profiles(&Disk)?;
        let accounts = Accounts::new(ready.controller.devices.state.profiles.known(), profiles);
        let unchecked: Vec<String> = accounts.without_password_check().map(|name| format!("`{name}`")).collect();
        let port = SoapPort::start(address)?;
        to_stderr(|out| {
            writeln!(out, "note: clients reach the controller at http://{}/", port.address())?;
            if !port.is_local() {
                writeln!(out, "note: other machines reach it, too; the interface has no encryption")?;
            }
            match unchecked.as_slice() {
                [] => Ok(()),
                names => writeln!(
                    out,
                    "note: any password is accepted for {}, because the cell contains passwords only obscured; set them \
                     in val3.toml ([run.profiles])",
                    names.join(", ")
                ),
            }
        });
        Ok(Self { port, service: Service::new(accounts), begin: Instant::now() })
    }

    /// Answers the pending requests.
    pub(super) fn attend(&mut self, mut target: ServiceTarget<'_>) {
        for _ in 0..CALLS_PER_CYCLE {
            let Some(call) = self.port.next_call() else { return };
            self.answer(call, &mut target);
        }
    }

    /// Waits for this time, and answers the requests that arrive meanwhile.
    pub(super) fn wait(&mut self, time: Duration, mut target: ServiceTarget<'_>) {
        let end = Instant::now() + time;
        loop {
            let Some(call) = self.port.wait_for_call(end.saturating_duration_since(Instant::now())) else { return };
            self.answer(call, &mut target);
            if Instant::now() >= end {
                return;
            }
        }
    }

    fn answer(&mut self, call: PendingCall, target: &mut ServiceTarget<'_>) {
        let answer = self.service.answer(&call.call, target, self.begin.elapsed());
        call.answer(answer);
    }
}
