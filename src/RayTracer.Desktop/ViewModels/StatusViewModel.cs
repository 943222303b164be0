using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The progress of the rendering and of the jobs beside it.</summary>
internal sealed class StatusViewModel(SessionDispatcher dispatcher) : Observable
{
    private RenderStatus _render = new();
    private int _threads;
    private IReadOnlyList<JobViewModel> _jobs = [];

    /// <summary>Returns whether a picture exists.</summary>
    public bool IsShown => _render.Width > 0;

    public bool IsRendering => _render.Status == "rendering";

    /// <summary>"rendering", "paused" …, in words.</summary>
    public string State => SessionTexts.Of($"status.states.{_render.Status}");

    /// <summary>The progress, 0 to 1.</summary>
    public double Fraction => (double)_render.Samples / Math.Max(1, _render.SamplesTotal);

    /// <summary>Samples in words.</summary>
    public string Samples => SessionTexts.Of("status.samples", _render.Samples, _render.SamplesTotal);

    /// <summary>Rays a second in words.</summary>
    public string Rays => SessionTexts.Of("status.rays", Figures.WithPrefix(_render.RaysPerSecond));

    /// <summary>The noise in words; empty where it is not known.</summary>
    public string Noise => _render.Noise is { } noise ? SessionTexts.Of("status.noise", Figures.Short(noise * 100, 2)) : "";

    /// <summary>The time that is left, or that it took.</summary>
    public string Time => _render.SecondsLeft is { } left && IsRendering
        ? SessionTexts.Of("status.left", Figures.Duration(left)) : SessionTexts.Of("status.took", Figures.Duration(_render.Seconds));

    /// <summary>Samples that were left out, in words; empty where there are none.</summary>
    public string Bad => _render.BadSamples > 0 ? SessionTexts.Of("status.bad", _render.BadSamples) : "";

    /// <summary>The picture's size in words.</summary>
    public string Size => SessionTexts.Of("status.size", _render.Width, _render.Height);

    /// <summary>The threads in words.</summary>
    public string Threads => SessionTexts.Of("status.threads", _threads, Environment.ProcessorCount);

    /// <summary>The jobs beside the user's work.</summary>
    public IReadOnlyList<JobViewModel> Jobs => _jobs;

    /// <summary>Shows a state.</summary>
    public void Show(SessionState state)
    {
        (_render, _threads) = (state.Render, state.Settings.Threads);
        if (!state.Jobs.SequenceEqual(_jobs.Select(j => j.Job)))
        {
            _jobs = [.. state.Jobs.Select(j => new JobViewModel(j, () => dispatcher.Do(s => s.Jobs.Cancel(j.Id))))];
        }

        OnPropertyChanged("");
    }
}

/// <summary>Something that takes its time.</summary>
internal sealed class JobViewModel(Job job, Action cancel)
{
    /// <summary>The session's word.</summary>
    public Job Job => job;

    public string Text => job.Text;

    /// <summary>The progress, 0 to 1.</summary>
    public double Fraction => job.Fraction;

    public string CancelText => $"{SessionTexts.Of("status.cancel")}: {job.Text}";

    /// <summary>Ends it.</summary>
    public ICommand Cancel { get; } = new RelayCommand(cancel);
}
