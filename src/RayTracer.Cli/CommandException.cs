namespace RayTracer.Cli;

/// <summary>Ends a command with a message for the user.</summary>
/// <param name="status">One of <see cref="ExitStatus"/>.</param>
/// <param name="message">The fault and what was expected, in one sentence.</param>
internal sealed class CommandException(int status, string message) : Exception(message)
{
    /// <summary>The status that the command returns to the shell.</summary>
    public int Status { get; } = status;
}
