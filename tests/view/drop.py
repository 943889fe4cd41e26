# SPDX-License-Identifier: MIT
"""Drops a file on a window as file managers do: the XDND protocol, version 5 (freedesktop.org)."""
from Xlib import X, display
from Xlib.protocol import event


def drop_file(screen, target, path):
    """Ends when the window has taken the file."""
    server = display.Display(screen)
    window = server.create_resource_object("window", target)
    source = server.screen().root.create_window(0, 0, 1, 1, 0, server.screen().root_depth)
    atom = server.intern_atom
    uris = atom("text/uri-list")
    source.set_selection_owner(atom("XdndSelection"), X.CurrentTime)

    def send(kind, *data):
        window.send_event(event.ClientMessage(window=target, client_type=atom(kind), data=(32, [source.id, *data])))
        server.flush()

    def wait(kind):
        while True:
            got = server.next_event()
            if got.type == X.ClientMessage and got.client_type == atom(kind):
                return
            if got.type == X.SelectionRequest:
                got.requestor.change_property(got.property, uris, 8, ("file://" + path + "\r\n").encode())
                got.requestor.send_event(event.SelectionNotify(time=got.time, requestor=got.requestor, selection=got.selection,
                                                               target=got.target, property=got.property))
                server.flush()

    send("XdndEnter", 5 << 24, uris, 0, 0)
    send("XdndPosition", 0, 100 << 16 | 100, X.CurrentTime, atom("XdndActionCopy"))
    wait("XdndStatus")
    send("XdndDrop", 0, X.CurrentTime, 0, 0)
    wait("XdndFinished")
    server.close()
