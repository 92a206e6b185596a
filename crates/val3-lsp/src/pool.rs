//! The threads that compute: some for requests that the user waits for, and some for the rest.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// Bytes of stack a thread, ample for the deepest nesting the parser takes.
const STACK_SIZE: usize = 16 << 20;

/// Most threads of one priority: more would only wait for memory.
const MOST_THREADS: usize = 8;

type Job = Box<dyn FnOnce() + Send>;

/// The urgency of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Priority {
    /// The user waits for it.
    Latency,
    /// It runs in the background.
    Background,
}

/// A fixed number of threads for each priority; neither takes threads from the other.
#[derive(Clone)]
pub(crate) struct Pool {
    latency: Sender<Job>,
    background: Sender<Job>,
    threads: usize,
}

impl Pool {
    /// Starts the threads. They end when the pool and its copies are dropped and their jobs are done.
    pub(crate) fn start() -> std::io::Result<Self> {
        let threads = thread::available_parallelism().map_or(1, usize::from).min(MOST_THREADS);
        // One more thread keeps a long request from holding up a short one.
        let latency = workers("latency", threads + 1)?;
        Ok(Self { latency, background: workers("background", threads)?, threads })
    }

    /// The number of background threads.
    pub(crate) fn threads(&self) -> usize {
        self.threads
    }

    /// Adds a job. It must catch its own panics if its result is waited for.
    pub(crate) fn spawn(&self, priority: Priority, job: impl FnOnce() + Send + 'static) {
        let queue = match priority {
            Priority::Latency => &self.latency,
            Priority::Background => &self.background,
        };
        // The threads live as long as their queue.
        let _ = queue.send(Box::new(job));
    }
}

fn workers(name: &str, threads: usize) -> std::io::Result<Sender<Job>> {
    let (sender, receiver) = channel::<Job>();
    let receiver = Arc::new(Mutex::new(receiver));
    for number in 0..threads {
        let receiver = Arc::clone(&receiver);
        let builder = thread::Builder::new().name(format!("{name} {number}")).stack_size(STACK_SIZE);
        builder.spawn(move || work(&receiver))?;
    }
    Ok(sender)
}

fn work(jobs: &Mutex<Receiver<Job>>) {
    loop {
        let job = jobs.lock().unwrap_or_else(PoisonError::into_inner).recv();
        let Ok(job) = job else { return };
        // A panic of a job must not end its thread. The job itself has already reported it.
        let _ = catch_unwind(AssertUnwindSafe(job));
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn a_panic_ends_no_thread() {
        let pool = Pool::start().unwrap();
        for _ in 0..2 * (MOST_THREADS + 1) {
            pool.spawn(Priority::Latency, || panic!("a job"));
        }
        let (sender, receiver) = channel();
        pool.spawn(Priority::Latency, move || sender.send(1).unwrap());
        assert_eq!(receiver.recv_timeout(Duration::from_secs(10)), Ok(1));
    }

    #[test]
    fn background_work_does_not_delay_requests() {
        let pool = Pool::start().unwrap();
        let gate = Arc::new(Mutex::new(()));
        let closed = gate.lock().unwrap();
        for _ in 0..100 {
            let gate = Arc::clone(&gate);
            pool.spawn(Priority::Background, move || drop(gate.lock()));
        }
        let (sender, receiver) = channel();
        pool.spawn(Priority::Latency, move || sender.send(1).unwrap());
        assert_eq!(receiver.recv_timeout(Duration::from_secs(10)), Ok(1));
        drop(closed);
    }
}
