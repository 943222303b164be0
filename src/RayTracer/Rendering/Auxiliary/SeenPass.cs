namespace RayTracer.Rendering;

/// <summary>Makes pictures of a moving view before they are filtered: the light of one sample of each pixel, and what it sees.</summary>
/// <param name="scene">The scene.</param>
/// <param name="threads">The number of threads; 0 for one for each processor.</param>
internal sealed class SeenPass(Scene scene, int threads)
{
    private const int Edge = 64;

    /// <summary>Puts a sample of each pixel into planes.</summary>
    /// <param name="planes">Planes of the scene's size.</param>
    /// <param name="sample">The number of the sample.</param>
    /// <param name="cancellation">Ends the work after the tiles under way.</param>
    /// <returns>False if it was cancelled.</returns>
    /// <exception cref="AggregateException">A class of a plug-in threw an exception; a <see cref="RenderFailedException"/> says where.</exception>
    public bool Take(SeenPlanes planes, int sample, CancellationToken cancellation) => Parallel.ForEach(
        Tile.Cut(new(0, 0, planes.Rows.Width, planes.Rows.Height), Edge),
        new ParallelOptions { MaxDegreeOfParallelism = threads > 0 ? threads : Environment.ProcessorCount },
        () => new Worker(scene, planes),
        (tile, loop, worker) =>
        {
            if (cancellation.IsCancellationRequested)
            {
                loop.Stop();
                return worker;
            }

            worker.Take(tile, new(sample, sample + 1));
            return worker;
        },
        worker => worker.Close()).IsCompleted;

    // What each thread has.
    private sealed class Worker
    {
        private readonly SeenPlanes _planes;
        private readonly SeenThrough _beyond;
        private readonly SeenByPaths _paths;
        private readonly Wavefront _wavefront;

        public Worker(Scene scene, SeenPlanes planes)
        {
            int size = new RenderOptions().StreamSize;
            _planes = planes;
            _beyond = new(scene, size, Edge * Edge);
            _paths = new(scene, planes, _beyond);
            _wavefront = new(scene, size, Edge * Edge, _paths);
        }

        public void Close()
        {
            _wavefront.Close();
            _beyond.Close();
        }

        public void Take(in Tile tile, SampleRange sample)
        {
            try
            {
                _wavefront.Observe(tile, sample);
                if (_paths.FindRest() is { Length: > 0 } rest)
                {
                    _beyond.Take(_planes, rest, sample.First);
                }
            }
            catch (Exception e)
            {
                throw new RenderFailedException(tile, sample, e);
            }
        }
    }
}
