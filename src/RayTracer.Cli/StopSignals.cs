using System.Runtime.InteropServices;

namespace RayTracer.Cli;

/// <summary>
/// While it lives, the first Ctrl-C (SIGINT), SIGTERM, or SIGHUP (the terminal was closed) only asks for the end, so that what is done so
/// far can be
/// written; a second one ends the process at once.
/// </summary>
internal sealed class StopSignals : IDisposable
{
    private readonly CancellationTokenSource _source = new();
    private readonly Streams _streams;
    private readonly PosixSignalRegistration[] _registrations;

    /// <summary>Begins to listen.</summary>
    public StopSignals(Streams streams)
    {
        _streams = streams;
        _registrations =
        [
            PosixSignalRegistration.Create(PosixSignal.SIGINT, c => Handle(c, ExitStatus.Interrupted)),
            PosixSignalRegistration.Create(PosixSignal.SIGTERM, c => Handle(c, ExitStatus.Terminated)),
            PosixSignalRegistration.Create(PosixSignal.SIGHUP, c => Handle(c, ExitStatus.HungUp)),
        ];
    }

    /// <summary>Cancelled by the first signal.</summary>
    public CancellationToken Token => _source.Token;

    /// <summary>The exit status that belongs to the signal; 0 where none came.</summary>
    public int Status { get; private set; }

    /// <inheritdoc/>
    public void Dispose()
    {
        Array.ForEach(_registrations, r => r.Dispose());
        _source.Dispose();
    }

    private void Handle(PosixSignalContext context, int status)
    {
        const string ShowCursor = "\e[?25h";
        if (Status != 0)
        {
            // The progress bar hides the cursor, and will not come to show it again.
            _streams.Error.Write(_streams.HasTerminal ? ShowCursor : "");
            return;
        }

        context.Cancel = true;
        Status = status;
        _source.Cancel();
    }
}
