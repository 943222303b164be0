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

/// <summary>What stands in the way of a command, and may be overruled by whoever repeats it.</summary>
public enum DocumentConflict
{
    /// <summary>Nothing that could be overruled.</summary>
    None,

    /// <summary>There are changes that were not saved.</summary>
    Unsaved,

    /// <summary>There is a file of that name already.</summary>
    Exists,

    /// <summary>Somebody else has changed the file since it was opened or saved here.</summary>
    ChangedOnDisk,
}
