#!/bin/bash
# A study in parts, one a task of a Slurm array; once all have ended, the parts are put together:
#
#   job=$(sbatch --parsable --array=1-64 scenarios/studies/slurm.sh scenarios/studies/map-6306.toml output)
#   sbatch --dependency=afterok:$job --wrap "jeffcott study merge output/map-6306"
#
# A task that was killed goes on behind its last row when it is started again:
# sbatch --array=17 would count one part instead of 64, so PARTS tells how many there are:
#
#   PARTS=64 sbatch --array=17 scenarios/studies/slurm.sh scenarios/studies/map-6306.toml output
#SBATCH --cpus-per-task=4
#SBATCH --requeue

part="$SLURM_ARRAY_TASK_ID/${PARTS:-$SLURM_ARRAY_TASK_COUNT}"
exec "${JEFFCOTT:-jeffcott}" study "$1" --out "$2" --shard "$part" --threads "${SLURM_CPUS_PER_TASK:-1}"
