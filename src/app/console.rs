//! Windows gives a program that was opened by a double click a console of its own. The program's manifest says that it wants none,
//! which systems before Windows 11 24H2 do not read: there it is let go of once the window is there.

/// Lets go of a console that no other program is at; one that the program was started from stays, and takes its words.
#[cfg(windows)]
pub(super) fn leave_own() {
    use win32console::console::WinConsole;
    // The list has zeros where there is no further program.
    let is_alone = WinConsole::get_process_list().is_ok_and(|list| list.iter().filter(|id| **id != 0).count() == 1);
    if is_alone {
        // Where it stays it is in the way, no more.
        let _ = WinConsole::free_console();
    }
}

/// Elsewhere nobody gives one.
#[cfg(not(windows))]
pub(super) fn leave_own() {}
