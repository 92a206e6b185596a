//! Thread of the server.

use std::io;
use std::net::{SocketAddr, TcpListener};
use std::sync::Arc;
use std::thread::JoinHandle;

use tokio::runtime;
use tokio::sync::watch;
use val3_modbus::ModbusImage;

use super::address::ModbusAddress;
use super::connections::{ConnectionLimits, accept};
use super::shared::SharedImage;
use crate::user_error::UserError;

/// Server for Modbus clients. Dropping the value closes all connections.
pub(super) struct Server {
    address: SocketAddr,
    image: Arc<SharedImage>,
    is_over: watch::Sender<bool>,
    thread: Option<JoinHandle<io::Result<()>>>,
}

impl Server {
    /// Starts a server for this number of clients.
    ///
    /// # Errors
    /// The address is in use, or a system resource for the server is not available.
    pub(super) fn start(address: ModbusAddress, image: ModbusImage, clients: u16) -> Result<Self, UserError> {
        Self::with_limits(address, image, ConnectionLimits::for_clients(clients))
    }

    pub(super) fn with_limits(
        address: ModbusAddress,
        image: ModbusImage,
        limits: ConnectionLimits,
    ) -> Result<Self, UserError> {
        let failed = |error: io::Error| UserError::new(format!("cannot serve Modbus: {error}"));
        let listener = address.listen()?;
        let address = own_address(&listener).map_err(failed)?;
        let image = Arc::new(SharedImage::new(image));
        let (is_over, watched) = watch::channel(false);
        let runtime = runtime::Builder::new_current_thread().enable_all().build().map_err(failed)?;
        let shared = Arc::clone(&image);
        let thread = std::thread::spawn(move || runtime.block_on(accept(listener, shared, limits, watched)));
        Ok(Self { address, image, is_over, thread: Some(thread) })
    }

    /// Address with the chosen port.
    pub(super) const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Accesses the values between two requests of clients.
    pub(super) fn exchange<T>(&self, access: impl FnOnce(&mut ModbusImage) -> T) -> T {
        access(&mut self.image.lock())
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.is_over.send_replace(true);
        // The thread may have ended already with a system error.
        self.thread.take().map(JoinHandle::join);
    }
}

fn own_address(listener: &TcpListener) -> io::Result<SocketAddr> {
    listener.set_nonblocking(true)?;
    listener.local_addr()
}
