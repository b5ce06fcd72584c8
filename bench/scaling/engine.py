"""A discrete event simulation of ranks that compute and send: waiting comes of who is late, and nothing else.

A rank is a generator (program.py). It yields
  ("work", seconds)               it computes
  ("start", outs, ins)            messages (rank, bytes) to others, and those that it is ready for
  ("finish", key)                 it waits until those of the start with that key are in
and gets its time back. start yields the key. A message of at most `eager` bytes leaves at once; a longer one
when its receiver has said that it is ready, two latencies later. Each message of a start but the first costs its
sender `overhead` of processor time, and its receiver as much when it has waited; a longer one `overhead_long`
more. Between nodes a message passes the adapter of its node and that of the other, each a queue of bytes / bandwidth
+ gap a message. Within a node its receiver copies it, one after the other: bytes / bandwidth_node."""

import heapq

READY, LEAVES, ARRIVES = range(3)


class Rank:
    def __init__(self, number, program):
        self.number = number
        self.program = program
        self.began = False
        self.time = 0.0
        self.waited = 0.0   # s in finish, without the overhead
        self.worked = 0.0   # s outside of messages
        self.sent = {}      # to whom: how many messages, so which one is next
        self.ready = {}     # from whom: how many it has been ready for
        self.missing = {}   # key: messages that have not come
        self.last = {}      # key: when the last of those that have came
        self.cost = {}      # key: s of processor time when they are in
        self.copied = 0.0   # when the last copy within its node ends
        self.blocked = None  # key


class Simulation:
    def __init__(self, constants, programs):
        self.c = constants
        self.ranks = [Rank(r, program) for r, program in enumerate(programs)]
        nodes = (len(self.ranks) - 1) // constants.cores + 1
        self.out_free, self.in_free = [0.0] * nodes, [0.0] * nodes
        self.events, self.number = [], 0
        self.early = {}    # (from, to, which): time of a message that nobody was ready for yet
        self.waits = {}    # (from, to, which): key of the receiver that is ready for it
        self.asked = {}    # (from, to, which): long message whose receiver is not ready: (time, bytes)
        self.ready_at = {}  # (from, to, which): since when the receiver is ready
        self.messages = self.bytes = 0

    def run(self):
        """Until all programs have ended; the time of each rank at its end."""
        for rank in self.ranks:
            self._go_on(rank)
        while self.events:
            time, _, kind, what = heapq.heappop(self.events)
            if kind == READY:
                self._go_on(what)
            elif kind == LEAVES:
                self._leave(time, *what)
            else:
                self._arrive(time, *what)
        stuck = [rank.number for rank in self.ranks if rank.blocked is not None]
        assert not stuck, f"ranks wait for ever: {stuck}"
        return [rank.time for rank in self.ranks]

    def _push(self, time, kind, what):
        self.number += 1
        heapq.heappush(self.events, (time, self.number, kind, what))

    def _go_on(self, rank):
        """A rank computes and sends until it has to wait; what others do meanwhile reaches it then."""
        answer = rank.time if rank.began else None  # as a generator wants it
        rank.began = True
        while True:
            try:
                order = rank.program.send(answer)
            except StopIteration:
                return
            if order[0] == "work":
                rank.time += order[1]
                rank.worked += order[1]
                answer = rank.time
            elif order[0] == "start":
                answer = self._start(rank, order[1], order[2])
            elif self._finish(rank, order[1]):
                answer = rank.time
            else:
                return

    def _start(self, rank, outs, ins):
        self.number += 1
        key = self.number
        rank.missing[key], rank.last[key] = 0, 0.0
        rank.cost[key] = self._cost(ins)
        for peer, _ in ins:
            which = rank.ready.get(peer, 0)
            rank.ready[peer] = which + 1
            name = (peer, rank.number, which)
            if name in self.early:
                rank.last[key] = max(rank.last[key], self.early.pop(name))
                continue
            rank.missing[key] += 1
            self.waits[name] = key
            self.ready_at[name] = rank.time
            if name in self.asked:
                self._send_long(name, *self.asked.pop(name))
        for k, (peer, size) in enumerate(outs):
            rank.time += (self.c.overhead if k > 0 else 0.0) + self._long(size)
            which = rank.sent.get(peer, 0)
            rank.sent[peer] = which + 1
            name = (rank.number, peer, which)
            self.messages += 1
            self.bytes += size
            if size <= self.c.eager:
                self._send(name, rank.time, size)
            elif name in self.waits:
                self._send_long(name, rank.time, size)
            else:
                self.asked[name] = (rank.time, size)
        return key

    def _long(self, size):
        return self.c.overhead_long if size > self.c.eager else 0.0

    def _cost(self, messages):
        return max(len(messages) - 1, 0) * self.c.overhead + sum(self._long(size)
                                                                 for _, size in messages)

    def _same_node(self, name):
        return name[0] // self.c.cores == name[1] // self.c.cores

    def _send_long(self, name, time, size):
        """Its receiver is ready: the question goes there and the answer back."""
        latency = self.c.latency_node if self._same_node(name) else self.c.latency
        self._send(name, max(time + latency, self.ready_at[name]) + latency, size)

    def _send(self, name, time, size):
        if self._same_node(name):
            self._push(time + self.c.latency_node, ARRIVES, (name, size))
        else:
            self._push(time, LEAVES, (name, size))

    def _leave(self, time, name, size):
        node = name[0] // self.c.cores
        begin = max(time, self.out_free[node])
        self.out_free[node] = begin + size / self.c.bandwidth + self.c.gap
        self._push(begin + self.c.latency, ARRIVES, (name, size))

    def _arrive(self, time, name, size):
        if self._same_node(name):
            rank = self.ranks[name[1]]
            rank.copied = max(time, rank.copied) + size / self.c.bandwidth_node
            self._deliver(name, rank.copied)
            return
        node = name[1] // self.c.cores
        end = max(time, self.in_free[node]) + size / self.c.bandwidth
        self.in_free[node] = end + self.c.gap
        self._deliver(name, end)

    def _deliver(self, name, time):
        """A message is there from a time on."""
        key = self.waits.pop(name, None)
        self.ready_at.pop(name, None)
        if key is None:
            self.early[name] = time
            return
        rank = self.ranks[name[1]]
        rank.last[key] = max(rank.last[key], time)
        rank.missing[key] -= 1
        if rank.missing[key] == 0 and rank.blocked == key:
            self._end_wait(rank, key)
            self._push(rank.time, READY, rank)

    def _finish(self, rank, key):
        if rank.missing[key] > 0:
            rank.blocked = key
            return False
        self._end_wait(rank, key)
        return True

    def _end_wait(self, rank, key):
        wait = max(rank.last.pop(key) - rank.time, 0.0)
        rank.waited += wait
        rank.time += wait + rank.cost.pop(key)
        rank.blocked = None
        del rank.missing[key]
