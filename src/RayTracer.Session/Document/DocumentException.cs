namespace RayTracer.Session;

/// <summary>A command that cannot be carried out; the message says why, in one sentence for the user.</summary>
public sealed class DocumentException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public DocumentException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public DocumentException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public DocumentException()
    {
    }

    /// <summary>What the user may do about it by repeating the command.</summary>
    public DocumentConflict Conflict { get; init; }
}
