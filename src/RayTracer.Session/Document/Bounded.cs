namespace RayTracer.Session;

/// <summary>Copies what others send, and no more of it than was agreed.</summary>
internal static class Bounded
{
    /// <summary>Copies a stream to its end.</summary>
    /// <param name="from">The stream that is read.</param>
    /// <param name="to">The stream that is written.</param>
    /// <param name="most">The largest number of bytes.</param>
    /// <param name="complaint">The message where there are more.</param>
    /// <returns>The number of bytes.</returns>
    /// <exception cref="SessionException">There are more.</exception>
    public static long Copy(Stream from, Stream to, long most, string complaint)
    {
        byte[] block = new byte[1 << 16];
        long total = 0;
        for (int read = from.Read(block); read > 0; read = from.Read(block))
        {
            total += read;
            if (total > most)
            {
                throw new SessionException(complaint);
            }

            to.Write(block, 0, read);
        }

        return total;
    }

    /// <summary>As <see cref="Copy"/>, without holding up a thread.</summary>
    public static async Task<long> CopyAsync(Stream from, Stream to, long most, string complaint, CancellationToken cancellation)
    {
        byte[] block = new byte[1 << 16];
        long total = 0;
        for (int read = await from.ReadAsync(block, cancellation).ConfigureAwait(false); read > 0; read = await from.ReadAsync(block, cancellation).ConfigureAwait(false))
        {
            total += read;
            if (total > most)
            {
                throw new SessionException(complaint);
            }

            await to.WriteAsync(block.AsMemory(0, read), cancellation).ConfigureAwait(false);
        }

        return total;
    }
}
