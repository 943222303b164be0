namespace RayTracer.Acceleration;

/// <summary>Pieces of work that may be done in any order, handed out one by one to some threads.</summary>
internal static class ParallelLoop
{
    /// <summary>Does all pieces.</summary>
    /// <param name="threads">At most so many at a time.</param>
    /// <param name="pieces">The number of pieces.</param>
    /// <param name="work">Does the piece of this number.</param>
    public static void Run(int threads, int pieces, Action<int> work)
    {
        int next = 0;
        void Drain()
        {
            for (int piece = Interlocked.Increment(ref next) - 1; piece < pieces; piece = Interlocked.Increment(ref next) - 1)
            {
                work(piece);
            }
        }

        int workers = Math.Min(threads, pieces);
        if (workers <= 1)
        {
            Drain();
            return;
        }

        Parallel.For(0, workers, new ParallelOptions { MaxDegreeOfParallelism = workers }, _ => Drain());
    }
}
