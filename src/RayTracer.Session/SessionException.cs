namespace RayTracer.Session;

/// <summary>Something that the user asked for cannot be done; the message is a sentence for the user.</summary>
public sealed class SessionException : Exception
{
    /// <summary>An unnamed fault.</summary>
    public SessionException()
    {
    }

    /// <summary>Says what cannot be done, and why.</summary>
    public SessionException(string message) : base(message)
    {
    }

    /// <summary>Says what cannot be done, why, and of what kind that is.</summary>
    public SessionException(string message, SessionFault fault) : base(message) => Fault = fault;

    /// <summary>Says what cannot be done, and what caused it.</summary>
    public SessionException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>Of what kind it is.</summary>
    public SessionFault Fault { get; }
}
