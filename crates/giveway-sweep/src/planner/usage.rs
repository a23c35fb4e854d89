//! What the processes of a group use while they run, as Linux tells it in `/proc`.

use std::fs;

use rustix::param::{clock_ticks_per_second, page_size};
use rustix::process::Pid;

/// What a group of processes uses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Usage {
    /// CPU seconds so far, those of children that have ended among them.
    pub(super) cpu_seconds: f64,
    /// Resident memory of all processes in sum, in bytes.
    pub(super) bytes: u64,
}

/// What a group uses now; `None` where the system does not tell.
pub(super) fn of_group(group: Pid) -> Option<Usage> {
    let mut sum = None;
    for entry in fs::read_dir("/proc").ok()?.flatten() {
        let name = entry.file_name();
        let is_process = name.as_encoded_bytes().iter().all(u8::is_ascii_digit);
        if !is_process {
            continue;
        }
        // A process may be gone by now.
        let stat = fs::read_to_string(entry.path().join("stat")).unwrap_or_default();
        if let Some(usage) = of_stat(&stat, group.as_raw_pid()) {
            let sum: &mut Usage = sum.get_or_insert_default();
            sum.cpu_seconds += usage.cpu_seconds;
            sum.bytes += usage.bytes;
        }
    }
    sum
}

/// What a process uses by its line, if it belongs to a group. The name of its program, in
/// brackets, may hold anything.
fn of_stat(stat: &str, group: i32) -> Option<Usage> {
    let (_, rest) = stat.rsplit_once(')')?;
    let fields: Vec<&str> = rest.split_whitespace().collect();
    let number = |index: usize| fields.get(index)?.parse::<u64>().ok();
    (fields.get(2)?.parse() == Ok(group)).then_some(())?;
    let ticks = number(11)? + number(12)? + number(13)? + number(14)?;
    Some(Usage {
        cpu_seconds: ticks as f64 / clock_ticks_per_second() as f64,
        bytes: number(21)? * page_size() as u64,
    })
}

/// The most memory that this process held at once, in bytes. A child begins with this
/// figure: the system copies it, and a child that held less tells it as its own.
pub(super) fn own_peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let mut lines = status.lines();
    let line = lines.find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().trim_end_matches("kB").trim().parse().ok()?;
    Some(kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read_whatever_the_program_is_called() {
        let stat = "12 (a) b (c) S 1 77 77 0 -1 4194304 1 2 3 4 50 25 15 10 20 0 1 0 5 6 3 8";
        let usage = of_stat(stat, 77).unwrap();
        let ticks = clock_ticks_per_second() as f64;
        assert!((usage.cpu_seconds - 100.0 / ticks).abs() < 1e-9);
        assert_eq!(usage.bytes, 3 * page_size() as u64);
        assert_eq!(of_stat(stat, 78), None);
        assert_eq!(of_stat("", 78), None);
        assert_eq!(of_stat("12 (a) S 1 77", 77), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn this_process_has_a_peak() {
        assert!(own_peak().unwrap() > 100_000);
    }
}
