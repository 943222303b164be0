namespace RayTracer.Session;

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
