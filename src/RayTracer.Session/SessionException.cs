using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Something that the user asked for cannot be done; the message is a sentence or a clause for the user.</summary>
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

/// <summary>The reason why something that was asked for is not done.</summary>
public enum SessionFault
{
    /// <summary>The request makes no sense, or cannot be done; the message says why.</summary>
    Refused,

    /// <summary>There is no such thing.</summary>
    Missing,

    /// <summary>There is a file of that name already; it is replaced if the user repeats the command.</summary>
    Exists,

    /// <summary>There are changes that were not saved; they are lost if the user repeats the command.</summary>
    Unsaved,

    /// <summary>Somebody else has changed the file since it was opened or saved here; that is lost if the user repeats the command.</summary>
    ChangedOnDisk,
}

/// <summary>The sentences for the user about errors.</summary>
public static class Complaint
{
    /// <summary>One sentence; null where the program itself is at fault.</summary>
    public static string? Of(Exception fault) => fault switch
    {
        SessionException or JobException => Sentence(fault.Message),
        ImageWriteException or PictureException or IOException or UnauthorizedAccessException => fault.Message,
        OutOfMemoryException => "There is not enough memory.",
        _ => null,
    };

    private static string Sentence(string clause) =>
        clause.Length > 0 ? $"{char.ToUpperInvariant(clause[0])}{clause[1..].TrimEnd('.')}." : clause;
}
