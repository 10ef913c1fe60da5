# SPDX-License-Identifier: Apache-2.0
"""Just enough of Xlib for a test: what a window shows, files dropped on it, and a screen's density."""
import ctypes
import ctypes.util
import time

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
ATOM_STRING = 31
Z_PIXMAP, REPLACE = 2, 0
ulong, pointer = ctypes.c_ulong, ctypes.c_void_p


class Image(ctypes.Structure):
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.POINTER(ctypes.c_ubyte)), ("byte_order", ctypes.c_int), ("unit", ctypes.c_int),
                ("bit_order", ctypes.c_int), ("pad", ctypes.c_int), ("depth", ctypes.c_int),
                ("bytes_per_line", ctypes.c_int), ("bits_per_pixel", ctypes.c_int)]


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ulong), ("send_event", ctypes.c_int), ("display", pointer),
                ("window", ulong), ("message_type", ulong), ("format", ctypes.c_int), ("data", ctypes.c_long * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ulong), ("send_event", ctypes.c_int), ("display", pointer),
                ("owner", ulong), ("requestor", ulong), ("selection", ulong), ("target", ulong), ("property", ulong),
                ("time", ulong)]


class SelectionNotify(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ulong), ("send_event", ctypes.c_int), ("display", pointer),
                ("requestor", ulong), ("selection", ulong), ("target", ulong), ("property", ulong), ("time", ulong)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("client", ClientMessage), ("request", SelectionRequest),
                ("notify", SelectionNotify), ("room", ctypes.c_long * 24)]


class Screen:
    def __init__(self, name):
        self.x = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
        self.x.XOpenDisplay.restype = pointer
        self.x.XGetImage.restype = ctypes.POINTER(Image)
        for function in ("XInternAtom", "XDefaultRootWindow", "XCreateSimpleWindow"):
            getattr(self.x, function).restype = ulong
        self.display = pointer(self.x.XOpenDisplay(name.encode()))
        if not self.display:
            raise RuntimeError(f"no display {name}")
        self.root = self.x.XDefaultRootWindow(self.display)

    def close(self):
        self.x.XCloseDisplay(self.display)

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), 0)

    def capture(self, window, width, height):
        """Rows of RGB bytes of the window's upper left corner."""
        everything = ulong(~0 & 0xFFFFFFFF)
        image = self.x.XGetImage(self.display, ulong(window), 0, 0, width, height, everything, Z_PIXMAP)
        if not image:
            raise RuntimeError("the window cannot be captured")
        line, step = image.contents.bytes_per_line, image.contents.bits_per_pixel // 8  # B, G, R, maybe unused
        data = bytes(image.contents.data[: line * height])
        self.x.XDestroyImage(image)
        rows = [data[y * line : y * line + step * width] for y in range(height)]
        return [bytes(row[i + c] for i in range(0, step * width, step) for c in (2, 1, 0)) for row in rows]

    def send(self, window, kind, *values):
        event = Event()
        event.client.type, event.client.window, event.client.format = CLIENT_MESSAGE, window, 32
        event.client.message_type = self.atom(kind)
        for i, value in enumerate(values):
            event.client.data[i] = value
        self.x.XSendEvent(self.display, ulong(window), 0, ctypes.c_long(0), ctypes.byref(event))
        self.x.XFlush(self.display)

    def close_window(self, window):
        """As the close button of a window manager does."""
        self.send(window, "WM_PROTOCOLS", self.atom("WM_DELETE_WINDOW"), 0)

    def set_density(self, dots_per_inch):
        text = f"Xft.dpi:\t{dots_per_inch}\n".encode()
        self.x.XChangeProperty(self.display, ulong(self.root), ulong(self.atom("RESOURCE_MANAGER")), ulong(ATOM_STRING), 8,
                               REPLACE, text, len(text))
        self.x.XFlush(self.display)

    def drop(self, window, path, seconds=20):
        """Drops a file on the window: XDND version 5 (freedesktop.org), from the source's side."""
        source = self.x.XCreateSimpleWindow(self.display, ulong(self.root), 0, 0, 1, 1, 0, ulong(0), ulong(0))
        selection, uris, copy = self.atom("XdndSelection"), self.atom("text/uri-list"), self.atom("XdndActionCopy")
        self.x.XSetSelectionOwner(self.display, ulong(selection), ulong(source), ulong(0))
        self.send(window, "XdndEnter", source, 5 << 24, uris, 0, 0)
        self.send(window, "XdndPosition", source, 0, 20 << 16 | 20, 0, copy)
        end, dropped = time.monotonic() + seconds, False
        while time.monotonic() < end:
            event = self.next_event()
            if event is None:
                continue
            if event.type == SELECTION_REQUEST:
                self.answer(event.request, path.as_uri().encode() + b"\r\n")
            elif event.type == CLIENT_MESSAGE and event.client.message_type == self.atom("XdndStatus"):
                if not event.client.data[1] & 1:
                    raise RuntimeError("the window refuses the drop")
                if not dropped:
                    self.send(window, "XdndDrop", source, 0, 0)
                dropped = True
            elif event.type == CLIENT_MESSAGE and event.client.message_type == self.atom("XdndFinished"):
                return
        raise RuntimeError("the window does not answer the drop")

    def next_event(self):
        if self.x.XPending(self.display) == 0:
            time.sleep(0.01)
            return None
        event = Event()
        self.x.XNextEvent(self.display, ctypes.byref(event))
        return event

    def answer(self, request, text):
        self.x.XChangeProperty(self.display, ulong(request.requestor), ulong(request.property), ulong(request.target), 8,
                               REPLACE, text, len(text))
        event = Event()
        event.notify.type, event.notify.requestor, event.notify.selection = SELECTION_NOTIFY, request.requestor, request.selection
        event.notify.target, event.notify.property, event.notify.time = request.target, request.property, request.time
        self.x.XSendEvent(self.display, ulong(request.requestor), 0, ctypes.c_long(0), ctypes.byref(event))
        self.x.XFlush(self.display)
