using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Something that takes its time.</summary>
internal sealed class JobViewModel(Job job, Action cancel)
{
    /// <summary>The session's word.</summary>
    public Job Job => job;

    /// <summary>What is done.</summary>
    public string Text => job.Text;

    /// <summary>How far it is, 0 to 1.</summary>
    public double Fraction => job.Fraction;

    /// <summary>What the button says.</summary>
    public string CancelText => $"{SessionTexts.Of("status.cancel")}: {job.Text}";

    /// <summary>Ends it.</summary>
    public ICommand Cancel { get; } = new ActionCommand(cancel);
}
