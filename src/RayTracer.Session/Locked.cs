namespace RayTracer.Session;

/// <summary>Reads of values that several threads share.</summary>
internal static class Locked
{
    /// <summary>Returns a value that is read while a lock is held.</summary>
    public static T Read<T>(this Lock gate, Func<T> read)
    {
        lock (gate)
        {
            return read();
        }
    }
}
