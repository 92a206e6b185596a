//! Thread pool: some threads for requests that the user waits for, and some for background work.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// Stack size of a thread in bytes, sufficient for the deepest nesting that the parser accepts.
const STACK_SIZE: usize = 16 << 20;

/// Thread limit for each priority; more threads would only wait for memory.
const MOST_THREADS: usize = 8;

type Job = Box<dyn FnOnce() + Send>;

/// Priority of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Priority {
    /// The user waits for the result.
    Latency,
    /// Background work.
    Background,
}

/// A fixed number of threads for each priority. A thread executes only jobs with its priority.
#[derive(Clone)]
pub(crate) struct Pool {
    latency: Sender<Job>,
    background: Sender<Job>,
    threads: usize,
}

impl Pool {
    /// Starts the threads. They end when the pool and its clones are dropped and all jobs are complete.
    pub(crate) fn start() -> std::io::Result<Self> {
        let threads = thread::available_parallelism().map_or(1, usize::from).min(MOST_THREADS);
        // With one additional thread, a long request does not delay a short one.
        let latency = workers("latency", threads + 1)?;
        Ok(Self { latency, background: workers("background", threads)?, threads })
    }

    /// Number of background threads.
    pub(crate) fn threads(&self) -> usize {
        self.threads
    }

    /// Adds a job. The job must catch its own panics if another thread waits for its result.
    pub(crate) fn spawn(&self, priority: Priority, job: impl FnOnce() + Send + 'static) {
        let queue = match priority {
            Priority::Latency => &self.latency,
            Priority::Background => &self.background,
        };
        // The threads live as long as their queue, so sending cannot fail.
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
        // A panic in a job must not end the thread. The job has already reported it.
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
