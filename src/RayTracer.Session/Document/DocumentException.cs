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

    /// <summary>The conflict that the user may overrule by repeating the command.</summary>
    public DocumentConflict Conflict { get; init; }
}

/// <summary>The conflicts that stop a command unless the user repeats it.</summary>
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
